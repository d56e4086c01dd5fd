#pragma once

#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/files/json/json_writer.hpp"

#include <map>
#include <string>
#include <vector>

namespace forefront {

/// Returns the pairs of all periodic links of a mesh.
std::vector<PeriodicPairs> allPeriodicPairs(const MeshView &mesh);

/// Adds the member "periodic" to statistics: per link its names, its motion, and the numbers of its paired nodes,
/// counted from 1 as in files.
void addPeriodic(const std::vector<PeriodicPairs> &links, const std::map<std::int32_t, std::string> &names,
                 JsonWriter &json);

/// Returns a line per link: its names, its motion and the number of pairs.
std::string periodicLines(const std::vector<PeriodicPairs> &links, const std::map<std::int32_t, std::string> &names);

} // namespace forefront
