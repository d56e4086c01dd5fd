#include "core/files/gmsh/msh_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace forefront {

namespace {

constexpr std::int64_t kAnyInteger = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kGreatestTag4 = std::numeric_limits<std::int32_t>::max();

} // namespace

/// Keeps the first physical group of every entity.
bool MshFile::readEntities4() {
    std::size_t counts[4] = {};
    for (std::size_t &count : counts) {
        if (!scanner_.count(count, 8, {"the number of entities"})) {
            return false;
        }
    }
    for (int dimension = 0; dimension < 4; ++dimension) {
        for (std::size_t k = 0; k < counts[dimension]; ++k) {
            if (!readEntity4(dimension)) {
                return false;
            }
        }
    }
    return true;
}

bool MshFile::readEntity4(int dimension) {
    std::int64_t entity = 0;
    return scanner_.integer(entity, -kAnyInteger, kAnyInteger, {"the tag of an entity"}) &&
           readEntityRest4(dimension, entity);
}

void MshFile::noteSeveralGroups(std::size_t groups, std::size_t place) {
    if (groups > 1) {
        scanner_.source().note("several-groups", "of the physical groups of an entity, only the first is kept", place);
    }
}

bool MshFile::readEntityRest4(int dimension, std::int64_t entity) {
    std::int64_t number = 0;
    double coordinate = 0.0;
    std::size_t physicals = 0, bounds = 0;
    const int coordinates = dimension == 0 ? 3 : 6;
    for (int k = 0; k < coordinates; ++k) {
        if (!scanner_.real(coordinate, {"the bounds of an entity"})) {
            return false;
        }
    }
    if (!scanner_.count(physicals, 2, {"the number of physical tags"})) {
        return false;
    }
    noteSeveralGroups(physicals, scanner_.offset());
    for (std::size_t k = 0; k < physicals; ++k) {
        if (!scanner_.integer(number, -kGreatestTag4, kGreatestTag4, {"a physical tag"})) {
            return false;
        }
        if (k == 0 && number != 0) {
            physical_.emplace(std::pair(dimension, entity), static_cast<std::int32_t>(std::abs(number)));
        }
    }
    if (dimension > 0) {
        if (!scanner_.count(bounds, 2, {"the number of bounding entities"})) {
            return false;
        }
        for (std::size_t k = 0; k < bounds; ++k) {
            if (!scanner_.integer(number, -kAnyInteger, kAnyInteger, {"a bounding entity"})) {
                return false;
            }
        }
    }
    return true;
}

/// Reads blocks of node numbers followed by coordinates; nodes are kept in the order of their numbers.
bool MshFile::readNodes4() {
    std::size_t blocks = 0, count = 0;
    std::int64_t number = 0;
    if (!scanner_.count(blocks, 6, {"the number of node blocks"}) ||
        !scanner_.count(count, 8, {"the number of nodes"}) ||
        !scanner_.integer(number, 0, kAnyInteger, {"the minimum node number"}) ||
        !scanner_.integer(number, 0, kAnyInteger, {"the maximum node number"})) {
        return false;
    }
    std::vector<NumberedNode> nodes;
    nodes.reserve(count);
    for (std::size_t block = 0; block < blocks; ++block) {
        std::int64_t dimension = 0, entity = 0, parametric = 0;
        std::size_t size = 0;
        if (!scanner_.integer(dimension, 0, 3, {"the dimension of node block", block + 1}) ||
            !scanner_.integer(entity, -kAnyInteger, kAnyInteger, {"the entity of node block", block + 1}) ||
            !scanner_.integer(parametric, 0, 1, {"the parametric flag of node block", block + 1}) ||
            !scanner_.count(size, 2, {"the number of nodes of node block", block + 1})) {
            return false;
        }
        const std::size_t first = nodes.size();
        if (size > count - first) {
            return scanner_.fail(scanner_.offset(), "bad-count",
                                 "the blocks hold more nodes than the " + std::to_string(count) +
                                     " that the section declares");
        }
        for (std::size_t k = 0; k < size; ++k) {
            if (!scanner_.integer(number, 1, kAnyInteger, {"the number of node", first + k + 1})) {
                return false;
            }
            nodes.push_back({number, {}});
        }
        const std::int64_t parameters = parametric == 1 ? dimension : 0;
        for (std::size_t k = first; k < nodes.size(); ++k) {
            double unused = 0.0;
            if (!builder_.readPlace(scanner_, nodes[k].number, 3, nodes[k].place)) {
                return false;
            }
            for (std::int64_t p = 0; p < parameters; ++p) {
                if (!scanner_.real(unused, {"the parameters of node", static_cast<std::uint64_t>(nodes[k].number)})) {
                    return false;
                }
            }
        }
    }
    return agrees(count, nodes.size(), "nodes") && takeNodes(std::move(nodes));
}

/// Refuses a section whose blocks hold fewer nodes or elements than it declares.
bool MshFile::agrees(std::size_t declared, std::size_t found, const char *what) {
    return found == declared || scanner_.fail(scanner_.offset(), "bad-count",
                                              "the section declares " + std::to_string(declared) + ' ' + what +
                                                  ", but its blocks hold " + std::to_string(found),
                                              "the file may have been cut short");
}

bool MshFile::takeNodes(std::vector<NumberedNode> nodes) {
    const auto byNumber = [](const NumberedNode &a, const NumberedNode &b) { return a.number < b.number; };
    if (!std::is_sorted(nodes.begin(), nodes.end(), byNumber)) {
        std::stable_sort(nodes.begin(), nodes.end(), byNumber);
    }
    builder_.reserveNodes(nodes.size());
    for (const NumberedNode &node : nodes) {
        builder_.mesh.nodes.push_back(node.place);
        builder_.table.add(node.number);
    }
    return builder_.finishNodes(scanner_);
}

bool MshFile::readElements4() {
    std::size_t blocks = 0, count = 0;
    std::int64_t number = 0;
    if (!scanner_.count(blocks, 8, {"the number of element blocks"}) ||
        !scanner_.count(count, 4, {"the number of elements"}) ||
        !scanner_.integer(number, 0, kAnyInteger, {"the minimum element number"}) ||
        !scanner_.integer(number, 0, kAnyInteger, {"the maximum element number"})) {
        return false;
    }
    std::size_t left = count;
    for (std::size_t block = 0; block < blocks; ++block) {
        if (!readElementBlock4(left)) {
            return false;
        }
    }
    if (!agrees(count, count - left, "elements")) {
        return false;
    }
    restoreOrder();
    return true;
}

/// Blocks group elements by entity; sorting by number restores the order of the writer.
void MshFile::restoreOrder() {
    const auto order = [](const std::vector<std::int64_t> &numbers) {
        std::vector<std::uint32_t> result(numbers.size());
        std::iota(result.begin(), result.end(), 0U);
        std::stable_sort(result.begin(), result.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return numbers[a] < numbers[b]; });
        return result;
    };
    const auto apply = [](auto &items, const std::vector<std::uint32_t> &positions) {
        auto sorted = items;
        for (std::size_t k = 0; k < items.size(); ++k) {
            sorted[k] = items[positions[k]];
        }
        items = std::move(sorted);
    };
    if (!std::is_sorted(edgeNumbers_.begin(), edgeNumbers_.end())) {
        apply(builder_.mesh.edges, order(edgeNumbers_));
    }
    if (!std::is_sorted(elementNumbers_.begin(), elementNumbers_.end())) {
        const auto positions = order(elementNumbers_);
        builder_.elements.arrange(positions);
        apply(elementPartitions_, positions);
        apply(elementNumbers_, positions);
    }
}

std::int32_t MshFile::tagOf(int dimension, std::int64_t entity) const {
    auto physical = physical_.find({dimension, entity});
    const MshPiece *const piece = pieceOf(dimension, entity);
    if (physical == physical_.end() && piece != nullptr) {
        physical = physical_.find({dimension, piece->parent});
        entity = piece->parent;
    }
    return physical != physical_.end() ? physical->second : ungrouped(entity);
}

bool MshFile::readElementBlock4(std::size_t &left) {
    std::int64_t dimension = 0, entity = 0, type = 0, number = 0;
    std::size_t size = 0;
    if (!scanner_.integer(dimension, 0, 3, {"the dimension of an element block"}) ||
        !scanner_.integer(entity, -kAnyInteger, kAnyInteger, {"the entity of an element block"})) {
        return false;
    }
    const std::size_t typeOffset = scanner_.offset() + 1;
    if (!scanner_.integer(type, 1, 1000, {"the type of an element block"}) ||
        !scanner_.count(size, 4, {"the number of elements of a block"})) {
        return false;
    }
    if (size > left) {
        return scanner_.fail(typeOffset, "bad-count", "the blocks hold more elements than the section declares");
    }
    left -= size;
    CellKind kind = CellKind::Point;
    if (size > 0 && !findKind(type, kind, "an element block", typeOffset)) {
        return false;
    }
    const std::int32_t tag = tagOf(static_cast<int>(dimension), entity);
    const MshPiece *const piece = pieceOf(static_cast<int>(dimension), entity);
    for (std::size_t k = 0; k < size; ++k) {
        if (!scanner_.integer(number, 0, kAnyInteger, {"the number of an element"}) ||
            !readConnection(kind, tag, {"element", static_cast<std::uint64_t>(number)})) {
            return false;
        }
        const int cellDimension = traitsOf(kind).dimension;
        if (piece != nullptr && piece->isInterface && cellDimension != 2) {
            ++interfaceParts_;
            cellDimension == 1 ? builder_.mesh.edges.pop_back() : builder_.mesh.points.pop_back();
        }
        if (builder_.mesh.edges.size() > edgeNumbers_.size()) {
            edgeNumbers_.push_back(number);
        }
        if (builder_.elements.size() > elementNumbers_.size()) {
            elementNumbers_.push_back(number);
            elementPartitions_.push_back(piece != nullptr ? piece->partition : 0);
        }
    }
    return true;
}

} // namespace forefront
