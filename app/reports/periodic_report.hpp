#pragma once

#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/files/json/json_writer.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace forefront {

/// The pairs of one periodic link, with the places of their nodes: files of several formats number nodes differently.
struct PlacedPairs : PeriodicPairs {
    std::vector<std::array<Vec2, 2>> places; ///< per pair: of the first node and of the second
};

/// Returns the pairs of all periodic links of a mesh.
std::vector<PlacedPairs> allPeriodicPairs(const MeshView &mesh);

/// Adds the member "periodic" to statistics: per link its names, its motion, and the places of its paired nodes as
/// [x, y, x, y].
void addPeriodic(const std::vector<PlacedPairs> &links, const std::map<std::int32_t, std::string> &names,
                 JsonWriter &json);

/// Returns a line per link: its names, its motion and the number of pairs.
std::string periodicLines(const std::vector<PlacedPairs> &links, const std::map<std::int32_t, std::string> &names);

} // namespace forefront
