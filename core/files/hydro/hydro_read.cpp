#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/tag_allocator.hpp"
#include "core/files/hydro/hydro.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::int64_t kGreatestId = std::numeric_limits<std::int32_t>::max();

/// Reads a grid of ADCIRC or SCHISM, as the ADCIRC user's manual describes fort.14. Each line begins with its numbers;
/// the rest of it is a comment, as programs write them there.
class GridReader {
  public:
    explicit GridReader(const SourceText &source) : scanner_(source) {}

    Result<MeshFields> read() {
        scanner_.skipLine(); // the title, which may be blank
        if (!sizes() || !nodes() || !elements() || !openParts() || !landParts()) {
            return scanner_.faults();
        }
        scanner_.source().numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(numbers_));
        MeshFields file;
        file.mesh = builder_.finish();
        file.mesh.boundaryNames = parts_.names();
        if (std::any_of(elevations_.begin(), elevations_.end(), [](double z) { return z != 0.0; })) {
            file.fields.emplace("elevation", std::move(elevations_));
        }
        return file;
    }

  private:
    /// Moves to the next line, which must be there.
    bool line(const char *what) {
        if (scanner_.ok() && !scanner_.nextLine(line_)) {
            scanner_.fail(scanner_.offset(), "bad-syntax",
                          std::string("expected ") + what + ", found the end of the file",
                          "the file may have been cut short");
        }
        return scanner_.ok();
    }
    /// Returns true, or takes over the failure of the line.
    bool taken(bool read) { return read || scanner_.fail(line_); }

    bool sizes() {
        constexpr std::size_t kLeast = 8; // bytes of the shortest line of a node or element
        return line("the numbers of elements and nodes") &&
               taken(line_.integer(elementCount_, 1, limit(kLeast), {"the number of elements"}) &&
                     line_.integer(nodeCount_, 3, limit(kLeast), {"the number of nodes"}));
    }
    /// Returns how many items of at least this many bytes the file can hold.
    std::int64_t limit(std::size_t bytes) const {
        return static_cast<std::int64_t>(scanner_.source().text.size() / bytes);
    }

    bool nodes() {
        builder_.reserveNodes(static_cast<std::size_t>(nodeCount_));
        elevations_.reserve(static_cast<std::size_t>(nodeCount_));
        for (std::int64_t k = 0; k < nodeCount_; ++k) {
            std::int64_t number = 0;
            double depth = 0.0;
            if (!line("a node") ||
                !taken(line_.integer(number, 0, kGreatestId, {"the number of a node"}) &&
                       builder_.readNode(line_, number, 2) &&
                       line_.real(depth, {"the depth of node", static_cast<std::uint64_t>(number)}))) {
                return false;
            }
            elevations_.push_back(0.0 - depth);
        }
        return builder_.finishNodes(scanner_);
    }

    bool elements() {
        for (std::int64_t k = 0; k < elementCount_; ++k) {
            std::int64_t number = 0, corners = 0;
            if (!line("an element") || !taken(line_.integer(number, 0, kGreatestId, {"the number of an element"}))) {
                return false;
            }
            const Expect expect{"element", static_cast<std::uint64_t>(number)};
            if (!taken(line_.integer(corners, 3, 4, {"the number of nodes of element", expect.number}) &&
                       builder_.readElement(line_, corners == 3 ? CellKind::Triangle3 : CellKind::Quadrilateral4, 1,
                                            expect))) {
                return false;
            }
            numbers_.push_back(number);
        }
        return true;
    }

    /// Reads the number of stretches of a kind, and skips that of their nodes. Grids without boundaries end before.
    bool stretchCount(std::int64_t &count, const char *what) {
        if (scanner_.atEnd()) {
            return true;
        }
        std::int64_t all = 0;
        return line(what) && taken(line_.integer(count, 0, limit(4), {what})) && line("the number of their nodes") &&
               taken(line_.integer(all, 0, kGreatestId, {"the number of boundary nodes"}));
    }

    bool openParts() {
        std::int64_t count = 0;
        if (!stretchCount(count, "the number of open boundaries")) {
            return false;
        }
        for (std::int64_t k = 0; k < count; ++k) {
            std::int64_t size = 0;
            if (!line("an open boundary") ||
                !taken(line_.integer(size, 0, limit(2), {"the number of nodes of an open boundary"})) ||
                !stretch(size, parts_.of("open_" + std::to_string(k + 1)), false, false)) {
                return false;
            }
        }
        return true;
    }

    bool landParts() {
        std::int64_t count = 0;
        if (!stretchCount(count, "the number of land boundaries")) {
            return false;
        }
        for (std::int64_t k = 0; k < count; ++k) {
            std::int64_t size = 0, type = 0;
            if (!line("a land boundary") ||
                !taken(line_.integer(size, 0, limit(2), {"the number of nodes of a land boundary"}) &&
                       line_.integer(type, 0, 999, {"the type of a land boundary"}))) {
                return false;
            }
            // The last digit of a type is its kind, the one before whether the flow may slip along it.
            const std::int64_t kind = type < 30 ? type % 10 : 2;
            const std::string name = kind == 0 ? "land" : kind == 1 ? "island" : "type_" + std::to_string(type);
            if (!stretch(size, parts_.of(name), kind == 1, kind == 4 || kind == 5)) {
                return false;
            }
        }
        return true;
    }

    /// Reads the nodes of a stretch, one a line. `closed`: the last is joined to the first. `paired`: each line has the
    /// node on the other side of a barrier, too.
    bool stretch(std::int64_t size, std::int32_t tag, bool closed, bool paired) {
        std::vector<NodeId> side, other;
        for (std::int64_t k = 0; k < size; ++k) {
            NodeId node{};
            if (!line("a node of a boundary") || !taken(builder_.readNodeId(line_, node, {"a boundary"}))) {
                return false;
            }
            side.push_back(node);
            if (paired) {
                if (!taken(builder_.readNodeId(line_, node, {"the other side of a barrier"}))) {
                    return false;
                }
                other.push_back(node);
            }
        }
        if (closed && side.size() > 2 && side.front() != side.back()) {
            side.push_back(side.front());
        }
        addEdges(side, tag);
        addEdges(other, tag);
        return true;
    }

    void addEdges(const std::vector<NodeId> &nodes, std::int32_t tag) {
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
            if (nodes[k] != nodes[k + 1]) {
                builder_.mesh.edges.push_back({nodes[k], nodes[k + 1], tag, kNoNode});
            }
        }
    }

    TextScanner scanner_;
    TextScanner line_ = scanner_;
    PlanarMeshBuilder builder_;
    std::int64_t elementCount_ = 0, nodeCount_ = 0;
    std::vector<std::int64_t> numbers_; ///< of elements
    std::vector<double> elevations_;
    TagAllocator parts_;
};

} // namespace

Result<MeshFields> readHydroFields(const SourceText &source) {
    return GridReader(source).read();
}

Result<Mesh> readHydro(const SourceText &source) {
    Result<MeshFields> file = readHydroFields(source);
    return file ? Result<Mesh>(std::move(file->mesh)) : file.faults();
}

} // namespace forefront
