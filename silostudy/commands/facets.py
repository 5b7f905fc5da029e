"""Command `silostudy facets MESH`: the triangles of an STL file, or of another mesh, as inserts to put into a scene."""

from pathlib import Path


def add(sub) -> None:
    command = sub.add_parser("facets", help="write the triangles of a mesh (STL, OBJ, PLY) as inserts of a scene of spheres")
    command.add_argument("mesh", type=Path, help="a mesh file; reading it needs `uv sync --group meshes`")
    command.add_argument("output", type=Path, help="YAML file to write, whose lines go into a scene")
    command.add_argument("--name", default="mesh", help="name that its forces are recorded under, facet by facet")
    command.add_argument("--unit", default="m", help="unit of the file's lengths: m or mm")
    command.set_defaults(run=run)


def run(chosen) -> None:
    import yaml

    from silostudy.files import replacing
    from silostudy.scene.facets import facets_of, read_triangles

    triangles = read_triangles(chosen.mesh)
    inserts = facets_of(triangles, chosen.name, chosen.unit, str(chosen.mesh))
    flat = len(triangles) - len(inserts)
    lines = [
        f"  - {yaml.safe_dump(insert, default_flow_style=True, sort_keys=False, width=1000).strip()}" for insert in inserts
    ]
    with replacing(chosen.output) as temporary:
        temporary.write_text("\n".join(["inserts:", *lines, ""]), encoding="utf-8")
    left_out = f", {flat} triangles without an area left out" if flat else ""
    print(f"{chosen.mesh}: {len(inserts)} facets{left_out} -> {chosen.output}")
