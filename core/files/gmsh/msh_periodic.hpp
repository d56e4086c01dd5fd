#pragma once

#include "core/engine/mesh/periodic_pairs.hpp"

#include <array>
#include <vector>

namespace forefront {

/// Returns the 16 numbers of a motion as a matrix by rows, as MSH files have them: it takes the nodes of the first
/// part, the master, to those of the second.
std::array<double, 16> affineOf(const RigidMap &map);

/// Writes the section $Periodic of MSH 4.1 as text or binary rows; nothing for a mesh without periodic parts.
/// `curve`: returns the number of the curve with a tag.
template <class Rows, class Curve>
void writeMsh4Periodic(const MeshView &mesh, Curve curve, Rows &rows) {
    if (mesh.periodic.empty()) {
        return;
    }
    rows.begin("Periodic");
    rows.size(mesh.periodic.size());
    rows.endRow();
    for (const PeriodicLink &link : mesh.periodic) {
        rows.integer(1);
        rows.integer(curve(link.to));
        rows.integer(curve(link.from));
        rows.endRow();
        const std::array<double, 16> affine = affineOf(link.map);
        rows.size(affine.size());
        for (const double value : affine) {
            rows.real(value);
        }
        rows.endRow();
        const PeriodicPairs found = periodicPairs(mesh, link);
        rows.size(found.pairs.size());
        rows.endRow();
        for (const NodePair &pair : found.pairs) {
            rows.size(index(pair.to) + 1);
            rows.size(index(pair.from) + 1);
            rows.endRow();
        }
    }
    rows.end("Periodic");
}

} // namespace forefront
