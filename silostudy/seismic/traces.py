"""Records of K-NET and KiK-net, which say their unit, and of all else that obspy reads, whose unit the user must say."""

import re
import warnings
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import Any

import numpy as np

from silostudy.errors import BadInput
from silostudy.seismic.units import agreed

BOM = b"\xef\xbb\xbf"
UNTRUSTED = "PICKLE"  # obspy looks whether a file is of this format by running what stands in it
SAC_KINDS = {6: "a displacement", 7: "a velocity", 50: "a voltage"}  # what a SAC header's idep says besides acceleration
PEAK_TOLERANCE = 0.05  # of the peak in a K-NET header, which knows another zero line than ours


def of_obspy(path: Path, unit: str | None, channel: str | None = None) -> tuple[np.ndarray, float]:
    """Accelerations (m s-2) and step (s) of one trace of a file; BadInput where it is not to be had."""
    try:
        content = path.read_bytes().removeprefix(BOM)
    except (OSError, ValueError) as error:
        raise BadInput("file", str(path), f"must be a readable file ({getattr(error, 'strerror', None) or error})") from None
    trace = _chosen(_traces(content, path), channel, path)
    data: np.ndarray = np.ma.filled(np.ma.asarray(trace.data, dtype=float), np.nan)
    if trace.stats["_format"] == "KNET":
        agreed(unit, _knet_unit(content, path), str(path))
        _check_knet(trace, path)
        return data * trace.stats.calib, trace.stats.delta  # obspy's calib turns counts into m s-2
    factor = agreed(unit, None, str(path))
    _check_acceleration(trace, path)
    return data * factor, trace.stats.delta


def _traces(content: bytes, path: Path) -> Any:
    """Stream (obspy) of a file's content, from a copy whose name has no meaning to obspy."""
    import obspy

    with NamedTemporaryFile() as copy, warnings.catch_warnings():
        copy.write(content)
        copy.flush()
        warnings.simplefilter("ignore")
        warnings.simplefilter("error", UserWarning)  # by which obspy tells of data it leaves out
        try:
            return obspy.read(copy.name, format=_form(copy.name, path), check_compression=False)
        except BadInput:
            raise
        except Exception as error:  # obspy has no common error
            told = " ".join(str(error).replace(copy.name, path.name).split())
            raise BadInput("record", str(path), f"obspy cannot read it ({type(error).__name__}: {told})") from None


def _form(name: str, path: Path) -> str:
    """The format of a file, as obspy finds it."""
    from obspy.core.util.base import ENTRY_POINTS, buffered_load_entry_point

    for form, entry in ENTRY_POINTS["waveform"].items():
        group = f"obspy.plugin.waveform.{entry.name}"
        if form != UNTRUSTED and buffered_load_entry_point(entry.dist.name, group, "isFormat")(name):
            return form
    raise BadInput(
        "record", str(path), "obspy cannot read it: a file of none of its formats (an archive must be unpacked first)"
    )


def _chosen(stream: Any, channel: str | None, path: Path) -> Any:
    """The one trace of a stream whose id (network.station.location.channel) or channel it is; the only one if none is named."""
    fits = [trace for trace in stream if channel is None or channel in (trace.id, trace.stats.channel)]
    if len(fits) == 1:
        return fits[0]
    held = ", ".join(dict.fromkeys(trace.id for trace in stream)) or "nothing"
    if not fits:
        raise BadInput("channel", channel, f"is not in the file, which holds {held}", str(path))
    if len({trace.id for trace in fits}) > 1:
        raise BadInput("channel", channel, f"must name one trace of the file, which holds {held}", str(path))
    raise BadInput("record", held, f"must be one gapless trace, not {len(fits)} pieces", str(path))


def _knet_unit(content: bytes, path: Path) -> str:
    """The unit in the Scale Factor of a K-NET header, which obspy takes for gal unread."""
    header = content[:4000].decode("ascii", errors="replace")
    scale = re.search(r"^Scale Factor\s+\d+\((\w+)\)/\d+(\.\d*)?\s*$", header, re.MULTILINE)
    rate = re.search(r"^Sampling Freq\(Hz\)\s+\d+\s*Hz\s*$", header, re.MULTILINE)
    if not scale or not rate:
        raise BadInput("record", str(path), "must have a K-NET header: Scale Factor N(gal)/N and Sampling Freq(Hz) NHz")
    if scale[1] != "gal":
        raise BadInput("Scale Factor", scale[0].strip(), "must be in gal", str(path))
    return scale[1]


def _check_knet(trace: Any, path: Path) -> None:
    """BadInput unless a K-NET file holds as many samples and as large a peak as its header says."""
    header, count = trace.stats.get("knet"), len(trace.data)
    if header is None:
        raise BadInput("record", str(path), f"must have a whole K-NET header before its {count} samples")
    said = header["duration"] * trace.stats.sampling_rate
    if count != said:
        told = f"says {header['duration']:g} s of {trace.stats.sampling_rate:g} Hz, {said:g} samples; the file holds {count}"
        raise BadInput("Duration Time", header["duration"], told, str(path))
    gal = 100 * trace.stats.calib * trace.data
    peaks = [float(np.abs(gal - zero).max()) for zero in (gal.mean(), gal[0])]
    if not header["accmax"] > 0 or not any(abs(peak / header["accmax"] - 1) <= PEAK_TOLERANCE for peak in peaks):
        told = f"is the header's peak (gal); the samples have {peaks[0]:.4g} about their mean"
        raise BadInput("Max. Acc.", header["accmax"], told, str(path))


def _check_acceleration(trace: Any, path: Path) -> None:
    """BadInput for samples that are counts, or by the file's header no acceleration."""
    if np.issubdtype(trace.data.dtype, np.integer):
        told = "are whole numbers, counts of a digitiser: turn them into accelerations first, by the instrument's response"
        raise BadInput("samples", str(trace.data.dtype), told, str(path))
    kind = SAC_KINDS.get(trace.stats.get("sac", {}).get("idep"))
    if kind:
        raise BadInput("idep", int(trace.stats.sac.idep), f"says that the file holds {kind}, no acceleration", str(path))
