#include "ui/workspace/mesh/element_words.hpp"

#include "ui/widgets/widgets.hpp"

#include <algorithm>

namespace forefront {

std::string elementsInWords(const MeshView &mesh) {
    std::array<std::size_t, wordsOf<CellKind>().size()> counts{};
    for (const MeshView::Block &block : mesh.blocks()) {
        counts[static_cast<std::size_t>(block.kind)] += block.size();
    }
    return elementsInWords(counts);
}

std::string elementsInWords(const std::array<std::size_t, wordsOf<CellKind>().size()> &counts) {
    std::string kinds;
    std::size_t different = 0, total = 0;
    for (const CellKind kind : kElementKinds) {
        if (const std::size_t count = counts[static_cast<std::size_t>(kind)]; count > 0) {
            const CellTraits &traits = traitsOf(kind);
            total += count;
            kinds +=
                (different++ == 0 ? "" : ", ") + ui::count(count) + ' ' + (count == 1 ? traits.name : traits.plural);
        }
    }
    if (different == 1) {
        return kinds;
    }
    return ui::count(total) + " elements" + (kinds.empty() ? "" : " (" + kinds + ')');
}

std::string elementsInShort(const MeshQuality &quality) {
    const bool others = std::any_of(kElementKinds.begin(), kElementKinds.end(), [&quality](CellKind kind) {
        return traitsOf(kind).corners != 3 && quality.kinds[static_cast<std::size_t>(kind)] > 0;
    });
    const char *const noun = quality.elements == 1 ? " element" : " elements";
    return ui::count(quality.elements) + (others ? noun : " \xe2\x96\xb3");
}

} // namespace forefront
