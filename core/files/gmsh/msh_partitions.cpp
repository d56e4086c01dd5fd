#include "core/files/gmsh/msh_file.hpp"

#include <cstdlib>
#include <limits>

namespace forefront {

namespace {

constexpr std::int64_t kAnyEntity = std::numeric_limits<std::int64_t>::max();
constexpr std::int32_t kGreatestPart = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kInt4 = sizeof(std::int32_t), kSize8 = sizeof(std::uint64_t), kReal8 = sizeof(double);

} // namespace

/// Reads the pieces into which Gmsh divides the entities of a partitioned mesh: the elements belong to them, the
/// physical groups to them or to the entities that they are pieces of.
bool MshFile::readPartitionedEntities4() {
    std::size_t partitions = 0, ghosts = 0, counts[4] = {};
    std::int64_t number = 0;
    if (!scanner_.count(partitions, 1, {"the number of partitions"}) ||
        !scanner_.count(ghosts, 4, {"the number of ghost entities"})) {
        return false;
    }
    for (std::size_t k = 0; k < 2 * ghosts; ++k) {
        if (!scanner_.integer(number, -kAnyEntity, kAnyEntity, {"a ghost entity"})) {
            return false;
        }
    }
    for (std::size_t &count : counts) {
        if (!scanner_.count(count, 10, {"the number of partitioned entities"})) {
            return false;
        }
    }
    for (int dimension = 0; dimension < 4; ++dimension) {
        for (std::size_t k = 0; k < counts[dimension]; ++k) {
            if (!readPartitionedEntity4(dimension)) {
                return false;
            }
        }
    }
    return true;
}

bool MshFile::readPartitionedEntity4(int dimension) {
    std::int64_t entity = 0, parentDimension = 0, parent = 0, number = 0;
    std::size_t partitions = 0;
    MshPiece piece;
    if (!scanner_.integer(entity, -kAnyEntity, kAnyEntity, {"the tag of a partitioned entity"}) ||
        !scanner_.integer(parentDimension, -1, 3, {"the dimension of a parent entity"}) ||
        !scanner_.integer(parent, -kAnyEntity, kAnyEntity, {"the tag of a parent entity"}) ||
        !scanner_.count(partitions, 2, {"the number of partitions of an entity"})) {
        return false;
    }
    for (std::size_t k = 0; k < partitions; ++k) {
        if (!scanner_.integer(number, 0, kGreatestPart, {"a partition"})) {
            return false;
        }
        piece.partition = k == 0 ? static_cast<std::int32_t>(number) : piece.partition;
    }
    piece.parent = parent;
    piece.isInterface = parentDimension != dimension;
    pieces_.insert_or_assign({dimension, entity}, piece);
    physical_.erase({dimension, entity});
    return readEntityRest4(dimension, entity);
}

bool MshFile::readPartitionedEntitiesBinary() {
    ByteScanner bytes(scanner_);
    std::uint64_t partitions = 0;
    std::size_t ghosts = 0, counts[4] = {};
    if (!bytes.number(partitions, {"the number of partitions"}) ||
        !bytes.count(ghosts, 2 * kInt4, {"the number of ghost entities"}) ||
        bytes.block(ghosts, 2 * kInt4, {"the ghost entities"}) == nullptr) {
        return false;
    }
    for (std::size_t &count : counts) {
        if (!bytes.count(count, 3 * kInt4 + 2 * kSize8 + 3 * kReal8, {"the number of partitioned entities"})) {
            return false;
        }
    }
    for (int dimension = 0; dimension < 4; ++dimension) {
        for (std::size_t k = 0; k < counts[dimension]; ++k) {
            if (!readPartitionedEntityBinary(bytes, dimension)) {
                return false;
            }
        }
    }
    return true;
}

bool MshFile::readPartitionedEntityBinary(ByteScanner &bytes, int dimension) {
    std::int32_t entity = 0, parentDimension = 0, parent = 0, number = 0;
    std::size_t partitions = 0;
    MshPiece piece;
    if (!bytes.number(entity, {"the tag of a partitioned entity"}) ||
        !bytes.integer(parentDimension, -1, 3, {"the dimension of a parent entity"}) ||
        !bytes.number(parent, {"the tag of a parent entity"}) ||
        !bytes.count(partitions, kInt4, {"the number of partitions of an entity"})) {
        return false;
    }
    for (std::size_t k = 0; k < partitions; ++k) {
        if (!bytes.integer(number, 0, kGreatestPart, {"a partition"})) {
            return false;
        }
        piece.partition = k == 0 ? number : piece.partition;
    }
    piece.parent = parent;
    piece.isInterface = parentDimension != dimension;
    pieces_.insert_or_assign({dimension, entity}, piece);
    physical_.erase({dimension, entity});
    return readEntityRestBinary(bytes, dimension, entity);
}

const MshPiece *MshFile::pieceOf(int dimension, std::int64_t entity) const {
    const auto found = pieces_.find({dimension, entity});
    return found == pieces_.end() ? nullptr : &found->second;
}

/// Makes the partitions of the elements a field, and notes the lines and points between them, which were left out.
void MshFile::takePartitions() {
    const std::size_t known = elementPartitions_.size();
    std::int32_t greatest = 0;
    for (const std::int32_t partition : elementPartitions_) {
        greatest = std::max(greatest, partition);
    }
    if (known != builder_.elements.size() || greatest == 0) {
        return;
    }
    const bool named = std::any_of(elementValues_.begin(), elementValues_.end(),
                                   [](const MshValues &field) { return field.name == "partition"; });
    if (!named) {
        MshValues field;
        field.name = "partition";
        field.offset = elementsOffset_;
        field.values.assign(elementPartitions_.begin(), elementPartitions_.end());
        elementValues_.push_back(std::move(field));
    }
    scanner_.source().note("partitions",
                           "the mesh is divided into " + std::to_string(greatest) +
                               " partitions; they are read as values of the elements named 'partition'",
                           elementsOffset_);
    if (interfaceParts_ > 0) {
        scanner_.source().note("partition-interface", "lines and points between partitions are left out",
                               elementsOffset_, interfaceParts_);
    }
}

} // namespace forefront
