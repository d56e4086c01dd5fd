"""Meshes as other packages have them. Classes in the place of packages that are not installed keep what they are given."""
import sys
import types

import numpy as np
import pytest

import forefront as ff


def _fake(monkeypatch, name, **members):
    module = types.ModuleType(name)
    vars(module).update(members)
    monkeypatch.setitem(sys.modules, name, module)


@pytest.fixture
def halves():
    """Two regions, 'left' and 'right', with named sides and a line between them."""
    domain = ff.Domain()
    domain.add_loop([(0, 0), (2, 0), (2, 1), (0, 1)], names=["bottom", "outlet", 7, "inlet"])
    domain.add_line([(1, 0), (1, 1)], names=9)
    domain.region((0.5, 0.5), "left")
    domain.region((1.5, 0.5), "right")
    return domain.repair()[0]


@pytest.mark.parametrize("name, call", [("pyvista", "to_pyvista"), ("skfem", "to_skfem"), ("dolfinx", "to_dolfinx"),
                                        ("meshio", "to_meshio"), ("matplotlib", "to_matplotlib")])
def test_a_package_that_is_missing_is_named(plate, monkeypatch, name, call):
    for loaded in [known for known in sys.modules if known.split(".")[0] == name] + [name, "matplotlib.tri"]:
        monkeypatch.setitem(sys.modules, loaded, None)
    with pytest.raises(ImportError, match=f"{name} is not installed; install it, for example with 'pip install "):
        getattr(ff.mesh(plate, 0.5), call)()


def test_pyvista_gets_cells_regions_and_values(halves, monkeypatch):
    class Grid:
        def __init__(self, cells, kinds, points):
            self.cells, self.kinds, self.points, self.cell_data, self.point_data = cells, kinds, points, {}, {}

    _fake(monkeypatch, "pyvista", UnstructuredGrid=Grid)
    mesh = ff.mesh(halves, 0.2)
    mesh.node_values["heat"] = mesh.nodes[:, 0]
    grid = mesh.to_pyvista()
    assert np.array_equal(grid.cells.reshape(-1, 4), np.column_stack([np.full(mesh.element_count, 3), mesh.elements]))
    assert set(grid.kinds) == {5} and len(grid.kinds) == mesh.element_count
    assert np.array_equal(grid.points[:, :2], mesh.nodes) and np.all(grid.points[:, 2] == 0)
    assert np.array_equal(grid.cell_data["region"], mesh.regions)
    assert np.array_equal(grid.point_data["heat"], mesh.nodes[:, 0])
    mixed = ff.mesh(halves, 0.2, elements="mixed", order=2, quad_nodes=9)
    blocks, grid = mixed.blocks, mixed.to_pyvista()
    assert grid.cells.size == sum(block.size + len(block) for block in blocks.values())
    assert {kind: int((grid.kinds == vtk).sum()) for kind, vtk in (("triangle6", 22), ("quadrilateral9", 28))} \
        == {"triangle6": 0, "quadrilateral9": 0, **{kind: len(block) for kind, block in blocks.items()}}


class _FacetMesh:
    """Lists its facets as scikit-fem does: the pairs of nodes of elements, ascending, each once."""

    def __init__(self, p, t):
        self.p, self.t = p, t
        sides = np.concatenate([t[[k, (k + 1) % len(t)]].T for k in range(len(t))])
        self.facets = np.unique(np.sort(sides, axis=1), axis=0).T

    def with_boundaries(self, boundaries):
        self.boundaries = boundaries
        return self

    def with_subdomains(self, subdomains):
        self.subdomains = subdomains
        return self


@pytest.mark.parametrize("elements, corners", [("triangles", 3), ("quads", 4)])
def test_skfem_gets_boundaries_and_subdomains_by_name(halves, monkeypatch, elements, corners):
    used = []
    make = lambda name: lambda p, t: used.append(name) or _FacetMesh(p, t)
    _fake(monkeypatch, "skfem", MeshTri=make("MeshTri"), MeshQuad=make("MeshQuad"))
    mesh = ff.mesh(halves, 0.2, elements=elements)
    made = mesh.to_skfem()
    assert used == ["MeshTri" if corners == 3 else "MeshQuad"]
    assert made.p.shape == (2, len(mesh.nodes)) and np.array_equal(made.t.T, mesh.elements)
    assert set(made.boundaries) == {"bottom", "outlet", "inlet", "boundary_7", "boundary_9"}
    x, y = made.p
    assert np.all(x[made.facets[:, made.boundaries["outlet"]]] == 2) and len(made.boundaries["outlet"]) >= 5
    assert np.all(x[made.facets[:, made.boundaries["boundary_9"]]] == 1)
    assert set(made.subdomains) == {"left", "right"}
    assert np.all(x[made.t[:, made.subdomains["left"]]] <= 1)
    assert sum(map(len, made.subdomains.values())) == mesh.element_count
    with pytest.raises(ValueError, match="to_skfem: expected triangles of 3 nodes .* got triangle6; use triangulated"):
        ff.mesh(halves, 0.5, order=2).to_skfem()


def _check_dolfinx(dolfinx, mesh, made, cell_tags, facet_tags, corners):
    """Compares places: dolfinx orders nodes and cells itself."""
    x = np.asarray(made.geometry.x)[:, :2]
    assert sorted(map(tuple, x.round(9).tolist())) == sorted(map(tuple, mesh.nodes.round(9).tolist()))
    links = made.geometry.dofmap
    cells = np.asarray(links.array if hasattr(links, "array") else links).reshape(-1, corners)
    centre = x[cells].mean(axis=1)
    left = next(tag for tag, name in mesh.region_names.items() if name == "left")
    assert np.array_equal(cell_tags.values[np.argsort(cell_tags.indices)] == left, centre[:, 0] < 1)
    around = x[cells[:, [0, 1, 2] if corners == 3 else [0, 1, 3, 2]]]  # quadrilaterals list their corners row by row
    after = np.roll(around, -1, axis=1)
    doubled = (around[..., 0] * after[..., 1] - around[..., 1] * after[..., 0]).sum(axis=1)
    assert np.abs(doubled).sum() == pytest.approx(4.0)
    counts = {tag: int((mesh.edge_tags == tag).sum()) for tag in np.unique(mesh.edge_tags).tolist()}
    assert {tag: int((facet_tags.values == tag).sum()) for tag in counts} == counts
    outlet = next(tag for tag, name in mesh.boundary_names.items() if name == "outlet")
    right = dolfinx.mesh.locate_entities_boundary(made, 1, lambda x: np.isclose(x[0], 2.0))
    assert np.array_equal(np.sort(facet_tags.indices[facet_tags.values == outlet]), np.sort(right))


@pytest.mark.parametrize("elements, corners", [("triangles", 3), ("quads", 4)])
def test_dolfinx_gets_cells_and_facets_with_tags(halves, elements, corners):
    dolfinx = pytest.importorskip("dolfinx")
    mesh = ff.mesh(halves, 0.2, elements=elements)
    made, cell_tags, facet_tags = mesh.to_dolfinx()
    _check_dolfinx(dolfinx, mesh, made, cell_tags, facet_tags, corners)


def test_dolfinx_refuses_second_order(halves, monkeypatch):
    _fake(monkeypatch, "dolfinx")
    _fake(monkeypatch, "dolfinx.mesh")
    with pytest.raises(ValueError, match="to_dolfinx: expected triangles of 3 nodes"):
        ff.mesh(halves, 0.5, order=2).to_dolfinx()
