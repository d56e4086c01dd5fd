#include "ui/workspace/mesh/element_words.hpp"

#include "ui/widgets/widgets.hpp"

#include <array>

namespace forefront {

std::string elementsInWords(const MeshView &mesh) {
    std::array<std::size_t, wordsOf<CellKind>().size()> counts{};
    for (const MeshView::Block &block : mesh.blocks()) {
        counts[static_cast<std::size_t>(block.kind)] += block.size();
    }
    std::string kinds;
    std::size_t different = 0;
    for (const CellKind kind : kElementKinds) {
        if (const std::size_t count = counts[static_cast<std::size_t>(kind)]; count > 0) {
            const CellTraits &traits = traitsOf(kind);
            kinds +=
                (different++ == 0 ? "" : ", ") + ui::count(count) + ' ' + (count == 1 ? traits.name : traits.plural);
        }
    }
    if (different == 1) {
        return kinds;
    }
    return ui::count(mesh.elementCount()) + " elements" + (kinds.empty() ? "" : " (" + kinds + ')');
}

} // namespace forefront
