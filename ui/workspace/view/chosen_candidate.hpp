#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/workspace/view/view.hpp"

#include <cstddef>
#include <optional>

namespace forefront {

/// Returns the candidate chosen in the view if it belongs to the advance that the snapshot explains.
std::optional<std::size_t> chosenCandidate(const View &view, const SessionSnapshot &snapshot);

} // namespace forefront
