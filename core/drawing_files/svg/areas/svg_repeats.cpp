#include "core/drawing_files/svg/areas/svg_repeats.hpp"

#include "core/drawing_files/svg/xml/svg_names.hpp"
#include "core/files/common/repeated_loops.hpp"

#include <cstddef>
#include <map>
#include <span>

namespace forefront {

std::vector<std::uint8_t> findRepeatedPaths(const std::vector<SvgPath> &paths,
                                            const std::function<bool(const SvgPath &)> &compares, double tolerance) {
    std::map<std::uint32_t, std::vector<std::size_t>> byClip;
    for (const bool named : {true, false}) {
        for (std::size_t k = 0; k < paths.size(); ++k) {
            if (isGeneratedName(paths[k].name) != named && compares(paths[k])) {
                byClip[paths[k].limit].push_back(k);
            }
        }
    }
    std::vector<std::uint8_t> repeated(paths.size(), 0);
    for (const auto &[clip, members] : byClip) {
        std::vector<std::span<const Vec2>> loops;
        for (const std::size_t k : members) {
            loops.emplace_back(paths[k].nodes);
        }
        const std::vector<std::uint8_t> found = findRepeatedLoops(loops, tolerance);
        for (std::size_t i = 0; i < members.size(); ++i) {
            repeated[members[i]] = found[i];
        }
    }
    return repeated;
}

std::map<std::size_t, std::size_t> subpathsOfElements(const std::vector<SvgPath> &paths) {
    std::map<std::size_t, std::size_t> counts;
    for (const SvgPath &path : paths) {
        ++counts[path.element];
    }
    return counts;
}

} // namespace forefront
