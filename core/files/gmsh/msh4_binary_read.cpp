#include "core/files/gmsh/msh_file.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>

namespace forefront {

namespace {

constexpr std::int32_t kAnyInt32 = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kInt = sizeof(std::int32_t), kSize = sizeof(std::uint64_t), kReal = sizeof(double);

} // namespace

/// Reads the integer 1 after the numbers of $MeshFormat, which shows the byte order.
bool MshFile::readByteOrder(std::int64_t size) {
    scanner_.nameBytes();
    const std::size_t place = scanner_.offset();
    if (size != 8) {
        return scanner_.fail(place, "unknown-size",
                             "unsupported size of counts: expected 8 bytes, found " + std::to_string(size),
                             "save it as ASCII: gmsh -save -bin 0");
    }
    ByteScanner bytes(scanner_);
    std::uint32_t one = 0;
    if (!bytes.number(one, {"the integer 1 that shows the byte order"})) {
        return false;
    }
    if (one == 0x01000000U) {
        return scanner_.fail(place, "byte-order", "the file is big-endian; only little-endian files can be read",
                             "save it as ASCII: gmsh -save -bin 0");
    }
    return one == 1 || scanner_.fail(place, "bad-syntax", "expected the binary integer 1 after the format");
}

bool MshFile::readEntitiesBinary() {
    ByteScanner bytes(scanner_);
    std::size_t counts[4] = {};
    for (std::size_t &count : counts) {
        if (!bytes.count(count, kInt + 3 * kReal, {"the number of entities"})) {
            return false;
        }
    }
    for (int dimension = 0; dimension < 4; ++dimension) {
        for (std::size_t k = 0; k < counts[dimension]; ++k) {
            if (!readEntityBinary(bytes, dimension)) {
                return false;
            }
        }
    }
    return true;
}

bool MshFile::readEntityBinary(ByteScanner &bytes, int dimension) {
    std::int32_t entity = 0;
    return bytes.number(entity, {"the tag of an entity"}) && readEntityRestBinary(bytes, dimension, entity);
}

bool MshFile::readEntityRestBinary(ByteScanner &bytes, int dimension, std::int64_t entity) {
    std::int32_t physical = 0;
    std::size_t physicals = 0, bounds = 0;
    if (bytes.block(dimension == 0 ? 3 : 6, kReal, {"the bounds of an entity"}) == nullptr ||
        !bytes.count(physicals, kInt, {"the number of physical tags"})) {
        return false;
    }
    noteSeveralGroups(physicals, bytes.offset());
    for (std::size_t k = 0; k < physicals; ++k) {
        if (!bytes.integer(physical, -kAnyInt32, kAnyInt32, {"a physical tag"})) {
            return false;
        }
        if (k == 0 && physical != 0) {
            physical_.emplace(std::pair(dimension, entity), std::abs(physical));
        }
    }
    return dimension == 0 || (bytes.count(bounds, kInt, {"the number of bounding entities"}) &&
                              bytes.block(bounds, kInt, {"the bounding entities"}) != nullptr);
}

bool MshFile::readNodesBinary() {
    ByteScanner bytes(scanner_);
    std::size_t blocks = 0, count = 0;
    if (!bytes.count(blocks, 3 * kInt + kSize, {"the number of node blocks"}) ||
        !bytes.count(count, kSize + 3 * kReal, {"the number of nodes"}) ||
        bytes.block(2, kSize, {"the minimum and maximum node number"}) == nullptr) {
        return false;
    }
    std::vector<NumberedNode> nodes;
    nodes.reserve(count);
    for (std::size_t block = 0; block < blocks; ++block) {
        if (!readNodeBlockBinary(bytes, block + 1, count, nodes)) {
            return false;
        }
    }
    return agrees(count, nodes.size(), "nodes") && takeNodes(std::move(nodes));
}

bool MshFile::readNodeBlockBinary(ByteScanner &bytes, std::size_t block, std::size_t limit,
                                  std::vector<NumberedNode> &nodes) {
    std::int32_t dimension = 0, entity = 0, parametric = 0;
    std::size_t size = 0;
    if (!bytes.integer(dimension, 0, 3, {"the dimension of node block", block}) ||
        !bytes.number(entity, {"the entity of node block", block}) ||
        !bytes.integer(parametric, 0, 1, {"the parametric flag of node block", block})) {
        return false;
    }
    const std::size_t sizePlace = bytes.offset();
    if (!bytes.count(size, kSize + 3 * kReal, {"the number of nodes of node block", block})) {
        return false;
    }
    if (size > limit - nodes.size()) {
        return bytes.fail(sizePlace, "bad-count", "the blocks hold more nodes than the section declares");
    }
    const std::size_t numbersPlace = bytes.offset();
    const char *const numbers = bytes.block(size, kSize, {"the node numbers of node block", block});
    const std::size_t placesPlace = bytes.offset();
    const std::size_t reals = 3 + static_cast<std::size_t>(parametric * dimension);
    const char *const places = bytes.block(size, reals * kReal, {"the coordinates of node block", block});
    if (numbers == nullptr || places == nullptr) {
        return false;
    }
    for (std::size_t k = 0; k < size; ++k) {
        const auto number = numberAt<std::int64_t>(numbers, k);
        if (number < 1) {
            return bytes.fail(numbersPlace + k * kSize, "out-of-range",
                              "the number of a node must be 1 or greater, found " + std::to_string(number));
        }
        if (!scanner_.proceed(placesPlace + k * reals * kReal)) {
            return false;
        }
        const Vec2 place{numberAt<double>(places, k * reals), numberAt<double>(places, k * reals + 1)};
        const auto z = numberAt<double>(places, k * reals + 2);
        const std::size_t offset = placesPlace + k * reals * kReal;
        if (!isFinite(place) || !std::isfinite(z)) {
            return bytes.fail(offset, "non-finite",
                              "the coordinates of node " + std::to_string(number) + " must be finite");
        }
        builder_.noteHeight(z, offset + 2 * kReal);
        nodes.push_back({number, place});
    }
    return true;
}

bool MshFile::readElementsBinary() {
    ByteScanner bytes(scanner_);
    std::size_t blocks = 0, count = 0;
    if (!bytes.count(blocks, 3 * kInt + kSize, {"the number of element blocks"}) ||
        !bytes.count(count, 2 * kSize, {"the number of elements"}) ||
        bytes.block(2, kSize, {"the minimum and maximum element number"}) == nullptr) {
        return false;
    }
    std::size_t left = count;
    for (std::size_t block = 0; block < blocks; ++block) {
        if (!readElementBlockBinary(bytes, left)) {
            return false;
        }
    }
    if (!agrees(count, count - left, "elements")) {
        return false;
    }
    restoreOrder();
    return true;
}

bool MshFile::findNode(std::int64_t number, NodeId &node, std::size_t place) {
    node = NodeId{builder_.table.find(number)};
    return node != kNoNode || scanner_.fail(place, "bad-index", "there is no node " + std::to_string(number));
}

bool MshFile::readElementBlockBinary(ByteScanner &bytes, std::size_t &left) {
    std::int32_t dimension = 0, entity = 0, type = 0;
    std::size_t size = 0;
    if (!bytes.integer(dimension, 0, 3, {"the dimension of an element block"}) ||
        !bytes.number(entity, {"the entity of an element block"})) {
        return false;
    }
    const std::size_t typePlace = bytes.offset();
    if (!bytes.number(type, {"the type of an element block"})) {
        return false;
    }
    CellKind kind = CellKind::Point;
    if (!findKind(type, kind, "an element block", typePlace)) {
        return false;
    }
    const std::size_t width = traitsOf(kind).nodes;
    const int cellDimension = traitsOf(kind).dimension;
    const std::size_t sizePlace = bytes.offset();
    if (!bytes.count(size, (1 + width) * kSize, {"the number of elements of a block"})) {
        return false;
    }
    if (size > left) {
        return bytes.fail(sizePlace, "bad-count", "the blocks hold more elements than the section declares");
    }
    left -= size;
    const std::size_t place = bytes.offset();
    const char *const rows = bytes.block(size, (1 + width) * kSize, {"the elements of a block"});
    const std::int32_t tag = tagOf(dimension, entity);
    const MshPiece *const piece = pieceOf(dimension, entity);
    for (std::size_t k = 0; rows != nullptr && k < size; ++k) {
        if (!scanner_.proceed(place + k * (1 + width) * kSize)) {
            return false;
        }
        const auto number = numberAt<std::int64_t>(rows, k * (1 + width));
        std::array<NodeId, kMaxCellNodes> all{};
        const std::span<NodeId> nodes = std::span(all).first(width);
        for (std::size_t n = 0; n < width; ++n) {
            const std::size_t item = k * (1 + width) + 1 + n;
            if (!findNode(numberAt<std::int64_t>(rows, item), nodes[n], place + item * kSize)) {
                return false;
            }
        }
        if (!requireDistinct(scanner_, place + k * (1 + width) * kSize, nodes,
                             {"element", static_cast<std::uint64_t>(number)})) {
            return false;
        }
        if (piece != nullptr && piece->isInterface && cellDimension != 2) {
            ++interfaceParts_;
            continue;
        }
        builder_.addCell(kind, nodes, tag);
        if (cellDimension == 1) {
            edgeNumbers_.push_back(number);
        } else if (cellDimension == 2) {
            elementNumbers_.push_back(number);
            elementPartitions_.push_back(piece != nullptr ? piece->partition : 0);
        }
    }
    return rows != nullptr;
}

} // namespace forefront
