#include "core/files/common/element_list.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

void ElementList::add(CellKind kind, std::span<const NodeId> nodes, std::int32_t region) {
    const auto found =
        std::find_if(blocks_.begin(), blocks_.end(), [&](const CellBlock &block) { return block.kind() == kind; });
    const auto block = static_cast<std::uint32_t>(found - blocks_.begin());
    if (found == blocks_.end()) {
        blocks_.emplace_back(kind);
        if (blocks_.size() == 2) { // from now on, the order of the file must be kept apart
            places_.resize(size());
            for (std::size_t e = 0; e < size(); ++e) {
                places_[e].row = static_cast<std::uint32_t>(e);
            }
        }
    }
    if (blocks_.size() > 1) {
        places_.push_back({block, static_cast<std::uint32_t>(blocks_[block].size())});
    }
    blocks_[block].add(nodes);
    regions.push_back(region);
}

bool ElementList::hasSecondOrder() const {
    return std::any_of(blocks_.begin(), blocks_.end(),
                       [](const CellBlock &block) { return block.traits().order == 2; });
}

void ElementList::arrange(std::span<const std::uint32_t> order) {
    ElementList list;
    for (const std::uint32_t e : order) {
        list.add(kindOf(e), nodesOf(e), regions[e]);
    }
    *this = std::move(list);
}

std::vector<std::size_t> ElementList::blockBegins() const {
    std::vector<std::size_t> begins;
    std::size_t begin = 0;
    for (const CellBlock &block : blocks_) {
        begins.push_back(begin);
        begin += block.size();
    }
    return begins;
}

PartNumbers ElementList::numbered(std::vector<std::int64_t> numbers) const {
    regroup(numbers);
    return PartNumbers(std::move(numbers));
}

PartNumbers ElementList::numberedFrom(std::int64_t first) const {
    if (places_.empty()) {
        return PartNumbers(first);
    }
    std::vector<std::int64_t> numbers(size());
    std::iota(numbers.begin(), numbers.end(), first);
    return numbered(std::move(numbers));
}

std::vector<CellBlock> ElementList::takeBlocks() {
    std::vector<std::int32_t> tags = std::move(regions);
    regroup(tags);
    if (blocks_.size() == 1) {
        blocks_.front().regions = std::move(tags);
    } else {
        auto next = tags.begin();
        for (CellBlock &block : blocks_) {
            const auto end = next + static_cast<std::ptrdiff_t>(block.size());
            block.regions.assign(next, end);
            next = end;
        }
    }
    std::vector<CellBlock> blocks = std::move(blocks_);
    *this = ElementList();
    return blocks;
}

} // namespace forefront
