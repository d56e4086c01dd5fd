#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// A physical group of curves as its file states it.
struct MshCurveGroup {
    std::string name;
    double length = 0.0; ///< of the chords of its lines; a line in several groups counts for the first
    bool curved = false; ///< it has lines of 3 nodes that are not straight
};

/// Returns the physical groups of curves of a valid ASCII file by number; std::nullopt for binary files. It shares no
/// code with readMsh, so that `check --domain` notices if readMsh mixes up groups.
std::optional<std::map<std::int32_t, MshCurveGroup>> mshCurveGroups(std::string_view text);

} // namespace forefront
