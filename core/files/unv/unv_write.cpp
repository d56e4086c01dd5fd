#include "core/files/common/names.hpp"
#include "core/files/common/part_groups.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/text/columns.hpp"
#include "core/files/unv/unv.hpp"
#include "core/files/unv/unv_cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string>

namespace forefront {

namespace {

constexpr std::string_view kDelimiter = "    -1\n";

/// Names have 40 characters, and readers stop at blanks; numbers have columns of 10, with a blank between them.
constexpr GroupLimits kUnvGroups = {999'999'999, 40, asIdentifier};

/// Writes integers in columns of 10, eight on a line.
class UnvRecord {
  public:
    explicit UnvRecord(TextWriter &out) : out_(out) {}
    template <class Integer>
    void add(Integer value) {
        writeColumn(out_, value, 10);
        if (++count_ % 8 == 0) {
            out_ << '\n';
        }
    }
    void end() {
        if (count_ % 8 != 0) {
            out_ << '\n';
        }
        count_ = 0;
    }

  private:
    TextWriter &out_;
    std::size_t count_ = 0;
};

void writeUnvRow(TextWriter &out, std::initializer_list<std::uint64_t> values) {
    UnvRecord record(out);
    for (const std::uint64_t value : values) {
        record.add(value);
    }
    record.end();
}

/// Writes a number with 17 digits, which read back to the same bits, and Fortran's exponent of double precision.
void writeUnvReal(TextWriter &out, double value) {
    std::array<char, 32> text;
    char *const end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 16).ptr;
    std::replace(text.data(), end, 'e', 'D');
    const auto length = static_cast<std::size_t>(end - text.data());
    out << std::string_view("         ").substr(0, 25 - std::min<std::size_t>(length, 25))
        << std::string_view(text.data(), length);
}

void writeUnvNodes(const MeshView &mesh, TextWriter &out) {
    out << kDelimiter << "  2411\n";
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        writeUnvRow(out, {n + 1, 1, 1, 11});
        writeUnvReal(out, mesh.nodes[n].x);
        writeUnvReal(out, mesh.nodes[n].y);
        writeUnvReal(out, 0.0);
        out << '\n';
    }
    out << kDelimiter;
}

void writeUnvCell(std::uint64_t label, CellKind kind, std::int32_t group, std::span<const NodeId> nodes,
                  TextWriter &out) {
    const auto number = static_cast<std::uint64_t>(group);
    writeUnvRow(out, {label, static_cast<std::uint64_t>(unvType(kind)), number, number, 7, nodes.size()});
    if (traitsOf(kind).dimension == 1) {
        writeUnvRow(out, {0, 1, 1});
    }
    UnvRecord record(out);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        record.add(index(nodes[unvNode(traitsOf(kind), k)]) + std::uint64_t{1});
    }
    record.end();
}

/// Numbers elements from 1 on, then edges.
void writeUnvCells(const MeshView &mesh, const PartGroups &groups, TextWriter &out) {
    out << kDelimiter << "  2412\n";
    std::uint64_t label = 0;
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size() && out.ok(); ++k) {
            writeUnvCell(++label, block.kind, groups.of(2, block.region(k)).number, block.nodesOf(k), out);
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        const EdgeNodes nodes(edge);
        writeUnvCell(++label, cellKindOf(edge), groups.of(1, edge.tag).number, std::span(nodes.begin(), nodes.end()),
                     out);
    }
    out << kDelimiter;
}

/// Writes a permanent group. `type`: of its entities, 7 nodes or 8 elements.
template <class Label>
void writeUnvGroup(const PartGroup &group, int type, const std::vector<std::uint32_t> &entities, Label label,
                   TextWriter &out) {
    writeUnvRow(out, {static_cast<std::uint64_t>(group.number), 0, 0, 0, 0, 0, 0, entities.size()});
    out << group.label << '\n';
    UnvRecord record(out);
    for (const std::uint32_t entity : entities) {
        record.add(type);
        record.add(label(entity));
        record.add(0);
        record.add(0);
    }
    record.end();
}

void writeUnvGroups(const MeshView &mesh, const PartGroups &groups, TextWriter &out) {
    if (groups.groups().empty()) {
        return;
    }
    out << kDelimiter << "  2467\n";
    for (const auto &[tag, elements] : elementsByRegion(mesh)) {
        writeUnvGroup(
            groups.of(2, tag), 8, elements, [](std::uint32_t e) { return e + std::uint64_t{1}; }, out);
    }
    for (const auto &[tag, edges] : edgesByTag(mesh)) {
        writeUnvGroup(
            groups.of(1, tag), 8, edges, [&](std::uint32_t k) { return mesh.elementCount() + k + 1; }, out);
    }
    for (const auto &[tag, points] : pointsByTag(mesh)) {
        writeUnvGroup(
            groups.of(0, tag), 7, points,
            [&](std::uint32_t k) { return index(mesh.points[k].node) + std::uint64_t{1}; }, out);
    }
    out << kDelimiter;
}

} // namespace

/// Writes the datasets 2411 (nodes), 2412 (elements and edges, whose property and material have the number of their
/// group) and 2467 (regions and boundary parts as permanent groups of elements, points as groups of nodes). Lines
/// before the first dataset, which readers skip, keep names and tags that differ in the file.
void writeUnv(const MeshView &mesh, TextWriter &out) {
    const PartGroups groups(mesh, kUnvGroups);
    groups.writeOrigins("#", out);
    writeUnvNodes(mesh, out);
    writeUnvCells(mesh, groups, out);
    writeUnvGroups(mesh, groups, out);
}

Diagnostics noteUnvChanges(const MeshView &mesh) {
    return PartGroups(mesh, kUnvGroups).noteChanges();
}

} // namespace forefront
