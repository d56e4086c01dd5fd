#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace forefront::fuzz {

/// Reads the bytes as a small domain with options of every kind, and meshes it: shapes and order of elements, layers,
/// periodic parts, cracks, mapped regions, strips, sizes. Aborts if the run crashes, does not end within a minute, ends
/// with a mesh that is wrong or has an element that is not positive and not reported, or is refused without a reason.
void runMesh(std::string_view bytes);

/// Reads the bytes as a project and meshes its drawing, with the same promises.
void runProject(std::string_view bytes);

/// Returns inputs for runMesh(): one for each kind of option, and some of many kinds.
std::vector<std::string> meshSeeds();
/// Returns inputs for runProject().
std::vector<std::string> projectSeeds();

} // namespace forefront::fuzz
