"""Arrays: views of the mesh that outlive it, and meshes made from arrays."""
import gc
import pickle

import numpy as np
import pytest

import forefront as ff


def test_arrays_are_read_only_views(plate):
    mesh = ff.mesh(plate, 0.2)
    for array, dtype in ((mesh.nodes, np.float64), (mesh.elements, np.uint32), (mesh.regions, np.int32),
                         (mesh.edges, np.uint32), (mesh.edge_tags, np.int32)):
        assert array.dtype == dtype
        assert array.base is not None and not array.flags.owndata and not array.flags.writeable
    first, second = (mesh.nodes.__array_interface__["data"][0] for _ in range(2))
    assert first == second
    assert np.array_equal(mesh.regions, np.ones(len(mesh.elements)))
    with pytest.raises(ValueError):
        mesh.nodes[0] = 0


def test_arrays_outlive_the_mesh(plate):
    mesh = ff.mesh(plate, 0.1)
    views = [mesh.nodes, mesh.elements, mesh.edges]
    copies = [np.array(view) for view in views]
    del mesh
    gc.collect()
    others = [ff.mesh(plate, 0.1 + 0.01 * k) for k in range(5)]  # would reuse the memory
    assert len(others) == 5
    for view, copy in zip(views, copies):
        assert np.array_equal(view, copy)


def test_neighbours_share_edges(plate):
    mesh = ff.mesh(plate, 0.3)
    beyond = mesh.neighbours
    assert np.count_nonzero(beyond < 0) == len(mesh.edges)
    for element, row in enumerate(beyond):
        for k, other in enumerate(row):
            if other >= 0:
                shared = {mesh.elements[element, k], mesh.elements[element, (k + 1) % 3]}
                assert shared <= set(mesh.elements[other]) and element in beyond[other]


def test_a_mesh_from_arrays_is_the_same(plate):
    mesh = ff.mesh(plate, 0.3)
    again = ff.Mesh(mesh.nodes, mesh.elements, mesh.regions, mesh.edges, mesh.edge_tags, mesh.boundary_names)
    assert again.hash == mesh.hash and again.nodes_of("hole").tolist() == mesh.nodes_of("hole").tolist()
    assert pickle.loads(pickle.dumps(mesh)).hash == mesh.hash
    plain = ff.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)])
    assert plain.regions.tolist() == [1] and plain.check() == [] and len(plain.edges) == 0
    with pytest.raises(ValueError, match="node 7 does not exist; expected 0 to 2"):
        ff.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 7)])


def test_renumbering_lowers_the_bandwidth_and_keeps_the_mesh(plate):
    mesh = ff.mesh(plate, 0.05)
    better = mesh.numbered("rcm")
    width = lambda m: int((m.elements.max(axis=1).astype(int) - m.elements.min(axis=1)).max())
    assert better.hash == mesh.hash and better.check(plate) == []
    assert width(better) < 120 < width(mesh)
    with pytest.raises(ValueError, match="each index of a node once"):
        mesh.numbered([0, 1])


def test_wrong_shapes_are_refused(rectangle):
    for wrong in ([(0, 0, 0)], [1, 2, 3], np.zeros((2, 2, 2))):
        with pytest.raises(ValueError, match=r"expected an array of shape \(n, 2\)"):
            ff.Domain().add_loop(wrong)
    domain = ff.Domain()
    with pytest.raises(ValueError, match="one name for each of the 4 segments, got 2"):
        domain.add_loop(rectangle, names=["a", "b"])
    assert len(domain.nodes) == len(domain.segments) == 0
