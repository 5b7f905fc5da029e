"""Opens netCDF files, whoever wrote them: whatever is wrong with one comes out as one line."""

from pathlib import Path

import netCDF4
import xarray as xr
from xarray.backends import NetCDF4DataStore

from silostudy.cube.trial import flaw
from silostudy.errors import BadInput
from silostudy.files import known_again


def opened(path: Path, field: str) -> xr.Dataset:
    """The content of a netCDF file, loaded into memory; BadInput(field) where it is none, or damaged."""
    if not is_file(path):
        raise BadInput(field, str(path), "must be a netCDF file; there is no file")
    if not known_again(path) and (told := flaw(path)):
        raise BadInput(field, str(path), f"must be a whole netCDF file: {told}")
    try:
        # opened here: xarray leaves a file open that it cannot decode, and HDF5 takes the next one in its place for the same
        with netCDF4.Dataset(path.absolute()) as file:
            held = xr.open_dataset(NetCDF4DataStore(file)).load()
            held.set_close(None)  # nothing is left to close
            return held
    except Exception as error:  # netCDF4, HDF5 and xarray have no common error
        told = " ".join(str(error).replace(str(path.absolute()), path.name).split())
        raise BadInput(field, str(path), f"must be a netCDF file ({type(error).__name__}: {told})") from None


def is_file(path: Path) -> bool:
    """Whether there is a file of that name; of a name that none can have there is none."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
