#include "core/engine/mesh/triangulated.hpp"
#include "core/files/common/element_sizes.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/common/names.hpp"
#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace forefront {

namespace {

constexpr std::int64_t kAny = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kGreatestTag = std::numeric_limits<std::int32_t>::max();

/// Cells that cannot be read, for messages.
struct OtherType {
    std::int64_t type;
    const char *name;
};
constexpr std::array<OtherType, 13> kOtherTypes = {{{4, "a tetrahedron"},
                                                    {5, "a hexahedron"},
                                                    {6, "a prism"},
                                                    {7, "a pyramid"},
                                                    {11, "a tetrahedron of 10 nodes"},
                                                    {12, "a hexahedron of 27 nodes"},
                                                    {17, "a hexahedron of 20 nodes"},
                                                    {20, "a triangle of 9 nodes"},
                                                    {21, "a triangle of 10 nodes"},
                                                    {23, "a triangle of 15 nodes"},
                                                    {26, "a line of 4 nodes"},
                                                    {27, "a line of 5 nodes"},
                                                    {36, "a quadrilateral of 16 nodes"}}};

} // namespace

bool MshFile::read() {
    while (scanner_.ok() && !scanner_.atEnd()) {
        const std::size_t place = scanner_.offset();
        const std::string_view word = scanner_.word();
        if (word.front() != '$') {
            return scanner_.fail(place, "bad-syntax", "expected a section such as $Nodes, found " + inQuotes(word));
        }
        if (word == "$NOD" && !formatRead_) {
            return scanner_.fail(place, "unknown-version", "MSH 1 cannot be read",
                                 "save it as MSH 2.2 or 4.1 with Gmsh");
        }
        if (!formatRead_ && word != "$MeshFormat" && word != "$Comments") {
            return scanner_.fail(place, "bad-syntax", "expected $MeshFormat as first section, found " + inQuotes(word));
        }
        readSection(word.substr(1));
    }
    if (scanner_.ok() && !nodesRead_) {
        return scanner_.fail(scanner_.offset(), "bad-syntax", "the file has no $Nodes");
    }
    if (scanner_.ok()) {
        if (!version4_) {
            dropRepeats();
        }
        scanner_.source().numbered(PartNumbers(builder_.table.numbers()), builder_.elements.numbered(elementNumbers_));
        takePartitions();
        resolveTags();
        for (MshValues &field : elementValues_) {
            builder_.elements.regroup(field.values);
        }
    }
    return scanner_.ok();
}

Mesh MshFile::takeMesh() {
    Mesh mesh = builder_.finish();
    restoreTags(origins_, mesh);
    findPeriodic(mesh);
    return mesh;
}

bool MshFile::readSection(std::string_view name) {
    bool done = false;
    if (name == "MeshFormat") {
        done = readFormat();
    } else if (name == "PhysicalNames") {
        done = readNames();
    } else if ((name == "Nodes" || (name == "ParametricNodes" && !version4_)) && !nodesRead_) {
        done = binary_ ? readNodesBinary() : version4_ ? readNodes4() : readNodes2(name != "Nodes");
        nodesRead_ = true;
    } else if (name == "Elements" && !elementsRead_) {
        if (!nodesRead_) {
            return scanner_.fail(scanner_.offset(), "bad-syntax", "$Elements come before $Nodes");
        }
        elementsOffset_ = scanner_.offset();
        done = binary_ ? readElementsBinary() : version4_ ? readElements4() : readElements2();
        elementsRead_ = true;
    } else if (name == "Entities" && version4_) {
        done = binary_ ? readEntitiesBinary() : readEntities4();
    } else if (name == "PartitionedEntities" && version4_) {
        done = binary_ ? readPartitionedEntitiesBinary() : readPartitionedEntities4();
    } else if (name == "NodeData" && nodesRead_) {
        done = readData(true);
    } else if (name == "ElementData" && elementsRead_) {
        done = readData(false);
    } else if (name == "Periodic" && nodesRead_) {
        done = readPeriodic();
    } else if (name == "Comments") {
        return readComments();
    } else {
        return skipSection(name);
    }
    return done && scanner_.literal("$End" + std::string(name));
}

/// Skips comments, except those of our own writer.
bool MshFile::readComments() {
    const std::size_t begin = scanner_.offset();
    if (!skipSection("Comments")) {
        return false;
    }
    std::vector<MshGroup> origins = readMshOrigins(scanner_.source().text.substr(begin, scanner_.offset() - begin));
    origins_.insert(origins_.end(), std::make_move_iterator(origins.begin()), std::make_move_iterator(origins.end()));
    return true;
}

bool MshFile::skipSection(std::string_view name) {
    const std::size_t place = scanner_.offset();
    if (name != "Comments" && name != "Entities") {
        scanner_.source().note("section", "section $" + std::string(name) + " is ignored", place);
    }
    const std::string end = "$End" + std::string(name);
    const std::size_t found = scanner_.source().text.find("\n" + end, place);
    if (found == std::string_view::npos) {
        return scanner_.fail(place, "bad-syntax", "the end of the section, " + end + ", is missing");
    }
    scanner_.seek(found);
    return scanner_.literal(end);
}

bool MshFile::readFormat() {
    double version = 0.0;
    std::int64_t binary = 0, size = 0;
    const std::size_t place = scanner_.offset();
    if (!scanner_.real(version, {"the version of the MSH format"}) ||
        !scanner_.integer(binary, 0, 1, {"the file type"})) {
        return false;
    }
    version4_ = version >= 4.0;
    if (version != 2.2 && version != 2.1 && version != 2.0 && version != 4.1) {
        return scanner_.fail(place, "unknown-version", "unsupported MSH version; expected 2.2 or 4.1",
                             "save it from gmsh with -format msh22 or msh41");
    }
    if (binary == 1 && !version4_) {
        return scanner_.fail(place, "binary", "binary MSH files of version 2 cannot be read",
                             "save it from gmsh with -format msh41, or as ASCII with -bin 0");
    }
    formatRead_ = true;
    binary_ = binary == 1;
    return scanner_.integer(size, 1, 16, {"the size of a number"}) && (!binary_ || readByteOrder(size));
}

bool MshFile::readNames() {
    std::size_t count = 0;
    if (!scanner_.count(count, 6, {"the number of physical names"})) {
        return false;
    }
    for (std::size_t k = 0; k < count; ++k) {
        std::int64_t dimension = 0, tag = 0;
        std::string_view name;
        const Expect expect{"physical name", k + 1};
        TextScanner ahead = scanner_;
        ahead.word();
        const bool bare = ahead.peek().starts_with('"'); // MSH 2.0: names have no dimension
        if ((!bare && !scanner_.integer(dimension, 0, 3, expect)) ||
            !scanner_.integer(tag, -kGreatestTag, kGreatestTag, expect) || !scanner_.quotedWord(name, expect)) {
            return false;
        }
        const auto group = static_cast<std::int32_t>(std::abs(tag));
        if (bare) {
            bareNames_.emplace(group, name);
        } else {
            addName(names_[static_cast<std::size_t>(dimension)], group, std::string(name), dimension == 2);
        }
    }
    return true;
}

/// Reads the nodes of MSH 2, one a line. In $ParametricNodes, their entities and parameters follow the coordinates.
bool MshFile::readNodes2(bool parametric) {
    std::size_t count = 0;
    if (!scanner_.count(count, 8, {"the number of nodes"})) {
        return false;
    }
    builder_.reserveNodes(count);
    for (std::size_t k = 0; k < count; ++k) {
        std::int64_t number = 0;
        if (!scanner_.integer(number, 1, kAny, {"the number of node", k + 1}) ||
            !builder_.readNode(scanner_, number, 3)) {
            return false;
        }
        if (parametric) {
            scanner_.skipLine();
        }
    }
    return builder_.finishNodes(scanner_);
}

bool MshFile::readElements2() {
    std::size_t count = 0;
    if (!scanner_.count(count, 6, {"the number of elements"})) {
        return false;
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!readElement2(k + 1)) {
            return false;
        }
    }
    return true;
}

bool MshFile::readElement2(std::size_t number) {
    std::int64_t id = 0, type = 0, tags = 0;
    if (!scanner_.integer(id, 0, kAny, {"the number of element", number})) {
        return false;
    }
    const Expect expect{"element", static_cast<std::uint64_t>(id)};
    const std::size_t typeOffset = scanner_.offset();
    if (!scanner_.integer(type, 1, 1000, expect) ||
        !scanner_.integer(tags, 0, 1000, {"the tags of element", static_cast<std::uint64_t>(id)})) {
        return false;
    }
    // The physical group, the entity of the model, the number of partitions, the partitions.
    std::int64_t group = 0, entity = 0, partition = 0;
    for (std::int64_t t = 0; t < tags; ++t) {
        std::int64_t tag = 0;
        if (!scanner_.integer(tag, -kGreatestTag, kGreatestTag, {"a tag of element", static_cast<std::uint64_t>(id)})) {
            return false;
        }
        (t == 0 ? group : entity) = t < 2 ? std::abs(tag) : entity;
        partition = t == 3 ? std::abs(tag) : partition;
    }
    const std::int32_t tag = group > 0 ? static_cast<std::int32_t>(group) : ungrouped(entity);
    CellKind kind = CellKind::Point;
    if (!findKind(type, kind, expect.words(), typeOffset) || !readConnection(kind, tag, expect)) {
        return false;
    }
    if (traitsOf(kind).dimension == 2) {
        elementNumbers_.push_back(id);
        elementPartitions_.push_back(static_cast<std::int32_t>(partition));
    }
    return true;
}

bool MshFile::readConnection(CellKind kind, std::int32_t tag, Expect expect) {
    switch (traitsOf(kind).dimension) {
    case 0:
        return builder_.readPoint(scanner_, tag, expect);
    case 1:
        return builder_.readEdge(scanner_, kind, tag, expect);
    default:
        return builder_.readElement(scanner_, kind, tag, expect);
    }
}

bool MshFile::findKind(std::int64_t type, CellKind &kind, const std::string &what, std::size_t place) {
    if (const auto found = cellNumbered(&CellTraits::gmsh, type)) {
        kind = *found;
        return true;
    }
    const auto known = std::find_if(kOtherTypes.begin(), kOtherTypes.end(),
                                    [&](const OtherType &other) { return other.type == type; });
    const std::string name = known == kOtherTypes.end() ? "" : std::string(" (") + known->name + ')';
    return scanner_.fail(place, "unknown-element",
                         what + " is of MSH type " + std::to_string(type) + name + "; only " + kReadableCells +
                             " can be read");
}

bool looksLikeMsh(std::string_view head) {
    return head.find("$MeshFormat") != std::string_view::npos || head.starts_with("$NOD");
}

Result<Mesh> readMsh(const SourceText &source) {
    MshFile file(source);
    if (!file.read()) {
        return file.faults();
    }
    return file.takeMesh();
}

Result<MeshFields> readMshFields(const SourceText &source) {
    MshFile file(source);
    if (!file.read()) {
        return file.faults();
    }
    const auto lastSteps = [&source](const std::vector<MshValues> &values) {
        NamedFields fields;
        for (const MshValues &field : values) {
            if (!fields.insert_or_assign(field.name, field.values).second) {
                source.note("time-steps", "of several time steps of the field '" + field.name + "', the last is read",
                            field.offset);
            }
        }
        return fields;
    };
    NamedFields fields = lastSteps(file.values()), elementFields = lastSteps(file.elementValues());
    return MeshFields{file.takeMesh(), std::move(fields), std::move(elementFields)};
}

Result<SpacingSpec> readMshSpacing(const SourceText &source) {
    MshFile file(source);
    if (!file.read()) {
        return file.faults();
    }
    TextScanner &scanner = file.scanner();
    if (file.values().empty()) {
        return elementSizes(file.takeMesh(), source);
    }
    TriMesh mesh = takeTriangulated(file.takeMesh()).mesh;
    if (mesh.elements.empty()) {
        scanner.fail(0, "no-values", "the file holds no elements with nodal values ($NodeData) to use as spacing");
        return scanner.faults();
    }
    const MshValues &values = file.values().front();
    if (file.values().size() > 1) {
        source.note("other-fields",
                    "the first field, '" + values.name + "', is the spacing; the other nodal values are ignored",
                    file.values()[1].offset, file.values().size() - 1);
    }
    if (values.notPositive != std::string_view::npos) {
        scanner.fail(values.notPositive, "bad-values", "a spacing must be greater than 0");
        return scanner.faults();
    }
    auto background = std::make_shared<BackgroundMesh>();
    background->nodes = std::move(mesh.nodes);
    background->values = values.values;
    background->elements.reserve(mesh.elements.size());
    for (const Element &element : mesh.elements) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = static_cast<std::uint32_t>(element[k]);
            if (std::isnan(values.values[corners[k]])) {
                scanner.fail(values.offset, "no-values", "some nodes of elements have no value in $NodeData");
                return scanner.faults();
            }
        }
        background->elements.push_back(corners);
    }
    // Nodes that no element uses have no value; any positive value will do.
    for (double &value : background->values) {
        value = std::isnan(value) ? 1.0 : value;
    }
    SpacingSpec spec;
    spec.background = std::move(background);
    return spec;
}

} // namespace forefront
