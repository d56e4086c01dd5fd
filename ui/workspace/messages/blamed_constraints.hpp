#pragma once

#include "ui/workspace/messages/message_log.hpp"

#include <cstdint>
#include <set>

namespace forefront {

/// Returns the ids of the constraints that the newest refusal by the sketch names, while the document still has the
/// revision that it is about.
std::set<std::uint32_t> blamedConstraints(const MessageLog &log, std::uint64_t revision);

} // namespace forefront
