#pragma once

#include "core/engine/mesh/periodic_pairs.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/gmsh/msh_groups.hpp"
#include "core/files/text/byte_scanner.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

/// Returns a number below 1 that stands for the tag of an entity without a physical group until all groups are known.
std::int32_t ungrouped(std::int64_t entity);

/// Values of a $NodeData or $ElementData section with one component.
struct MshValues {
    std::string name;
    std::size_t offset = 0;
    std::vector<double> values;                       ///< per node or element; NaN where the section has none
    std::size_t notPositive = std::string_view::npos; ///< offset of the first value that is 0 or less

    void set(std::size_t item, double value, std::size_t place) {
        if (!(value > 0.0)) {
            notPositive = std::min(notPositive, place);
        }
        values[item] = value;
    }
};

/// A piece of an entity of a partitioned mesh.
struct MshPiece {
    std::int64_t parent = 0;    ///< entity that it is a piece of
    std::int32_t partition = 0; ///< the first that it belongs to
    bool isInterface = false;   ///< lies between partitions, on an entity of a higher dimension
};

/// Reads Gmsh MSH 2.2, ASCII, and 4.1, ASCII and binary. Sections that are not used are skipped and reported.
class MshFile {
  public:
    explicit MshFile(const SourceText &source) : scanner_(source) {}

    /// Reads the whole file. Returns false after a failure; then see faults().
    bool read();
    const Diagnostics &faults() const { return scanner_.faults(); }
    TextScanner &scanner() { return scanner_; }
    /// Returns the mesh after read(), which can be done once.
    Mesh takeMesh();
    /// Returns the nodal values in the order of the file.
    const std::vector<MshValues> &values() const { return values_; }
    /// Returns the values of elements in the order of the file; each field in the order of the mesh.
    const std::vector<MshValues> &elementValues() const { return elementValues_; }

  private:
    bool readSection(std::string_view name);
    bool readFormat();
    bool readNames();
    /// Reads the values of a section, with those of nodes or of elements.
    bool readData(bool ofNodes);
    bool readDataHeader(MshValues &field, std::size_t &count, std::int64_t &components);
    bool readValue(bool ofNodes, std::size_t k, MshValues &field);
    /// Finds an element by its number; false if there is none.
    bool findElement(std::int64_t number, std::size_t &element);
    bool readComments();
    /// Reads the pairs of nodes of periodic entities.
    bool readPeriodic();
    bool readPeriodicEntity();
    bool readPeriodicBinary();
    /// Adds a pair to the last periodic curve; counts one with a node that the file does not have.
    void addPair(std::int64_t second, std::int64_t first);
    /// Gives the mesh the periodic links that the pairs of nodes of its boundary parts show.
    void findPeriodic(Mesh &mesh);
    bool skipSection(std::string_view name);

    bool readNodes2(bool parametric);
    bool readElements2();
    bool readElement2(std::size_t number);
    bool readEntities4();
    bool readEntity4(int dimension);
    /// Reads box, physical groups and bounds of an entity.
    bool readEntityRest4(int dimension, std::int64_t entity);
    void noteSeveralGroups(std::size_t groups, std::size_t place);
    bool readPartitionedEntities4();
    bool readPartitionedEntity4(int dimension);
    bool readNodes4();
    bool readElements4();
    bool readElementBlock4(std::size_t &left);
    bool agrees(std::size_t declared, std::size_t found, const char *what);
    void restoreOrder();

    struct NumberedNode {
        std::int64_t number;
        Vec2 place;
    };
    bool readByteOrder(std::int64_t size);
    bool readEntitiesBinary();
    bool readEntityBinary(ByteScanner &bytes, int dimension);
    bool readEntityRestBinary(ByteScanner &bytes, int dimension, std::int64_t entity);
    bool readPartitionedEntitiesBinary();
    bool readPartitionedEntityBinary(ByteScanner &bytes, int dimension);
    /// Returns the piece with that number; null if the entity is whole.
    const MshPiece *pieceOf(int dimension, std::int64_t entity) const;
    void takePartitions();
    void dropRepeats();
    bool readNodesBinary();
    bool readNodeBlockBinary(ByteScanner &bytes, std::size_t block, std::size_t limit,
                             std::vector<NumberedNode> &nodes);
    bool readElementsBinary();
    bool findNode(std::int64_t number, NodeId &node, std::size_t place);
    bool readElementBlockBinary(ByteScanner &bytes, std::size_t &left);
    bool readValuesBinary(bool ofNodes, std::size_t count, MshValues &field);

    /// Stores the nodes in the order of their numbers.
    bool takeNodes(std::vector<NumberedNode> nodes);
    /// Returns the tag of the parts on an entity: its first physical group, else a mark that resolveTags() replaces.
    std::int32_t tagOf(int dimension, std::int64_t entity) const;
    /// Gives separate tags to parts without a physical group, and to points with the number of a curve.
    void resolveTags();
    void spreadBareNames();
    void resolveRegions();
    void resolveEdgesAndPoints();
    void dropConstructionPoints();
    void placePoints(class MshTags &tags, bool groupedEdges);

    /// Finds the kind of cells of this type; refuses others.
    bool findKind(std::int64_t type, CellKind &kind, const std::string &what, std::size_t place);
    /// Reads the nodes of a cell that is number `number` in the file.
    bool readConnection(CellKind kind, std::int32_t tag, Expect expect);

    TextScanner scanner_;
    PlanarMeshBuilder builder_;
    std::vector<MshValues> values_, elementValues_;
    NodeTable elementTable_;        ///< of elementNumbers_, once a section needs it
    std::vector<MshGroup> origins_; ///< groups that our writer renumbered or renamed
    bool version4_ = false, binary_ = false, formatRead_ = false, nodesRead_ = false, elementsRead_ = false;
    std::map<std::pair<int, std::int64_t>, std::int32_t> physical_; ///< by dimension and entity
    std::array<std::map<std::int32_t, std::string>, 4> names_;      ///< of physical groups, by dimension
    std::map<std::int32_t, std::string> bareNames_;                 ///< MSH 2.0: of groups of any dimension
    std::size_t elementsOffset_ = 0;                                ///< of $Elements
    std::vector<std::int64_t> edgeNumbers_;                         ///< MSH 4.1: as in the file
    std::vector<std::int64_t> elementNumbers_;                      ///< of the elements, in the order of the file
    std::map<std::pair<int, std::int64_t>, MshPiece> pieces_;       ///< of a partitioned mesh, by dimension and number
    std::vector<std::int32_t> elementPartitions_; ///< of the elements, in the order of the file; 0: none
    std::vector<std::vector<NodePair>> periodic_; ///< of curves; each by nodes of the mesh
    std::size_t unknownPairs_ = 0;                ///< of periodic curves
    std::size_t interfaceParts_ = 0;              ///< lines and points between partitions
};

} // namespace forefront
