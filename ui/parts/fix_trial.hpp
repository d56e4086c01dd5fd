#pragma once

#include "core/drawing/commands/limit_fix.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

struct MeshSnapshot;
struct Shell;

/// A fix of a limit that the next mesh will judge.
struct FixTrial {
    std::vector<LimitVerdict> before;         ///< on the mesh without the fix
    std::shared_ptr<const MeshSnapshot> mesh; ///< that mesh
    std::string change;                       ///< see LimitFix::change
    std::uint64_t revision = 0;               ///< of the document with the fix
};

/// Applies a fix of a violated limit.
void tryFix(Shell &context, const LimitVerdict &verdict, LimitFix fix);
/// Takes the fix back, and says why, if the mesh with it is no better: see whyNoBetter(). Called once per frame.
void followFix(Shell &context);

} // namespace forefront
