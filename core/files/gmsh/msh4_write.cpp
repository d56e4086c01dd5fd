#include "core/files/gmsh/gmsh.hpp"
#include "core/files/gmsh/msh_model.hpp"
#include "core/files/gmsh/msh_periodic.hpp"

#include <algorithm>
#include <bit>

namespace forefront {

namespace {

/// Writes the numbers of sections as text, with blanks between those of a row.
class TextRows {
  public:
    explicit TextRows(TextWriter &out) : out_(out) {}

    void begin(const char *section) { out_ << '$' << section << '\n'; }
    void end(const char *section) { out_ << "$End" << section << '\n'; }
    void integer(std::int32_t value) { put(value); }
    void size(std::size_t value) { put(value); }
    void real(double value) { put(value); }
    void endRow() {
        out_ << '\n';
        first_ = true;
    }
    bool ok() const { return out_.ok(); }

  private:
    template <class Number>
    void put(Number value) {
        if (!first_) {
            out_ << ' ';
        }
        out_ << value;
        first_ = false;
    }

    TextWriter &out_;
    bool first_ = true; ///< the next number begins a row
};

static_assert(std::endian::native == std::endian::little, "binary MSH is written in the byte order of the machine");

/// Writes the numbers of sections as bytes. Integers have four, counts and the numbers of nodes and elements eight.
/// Section names stay text.
class BinaryRows {
  public:
    explicit BinaryRows(TextWriter &out) : out_(out) {}

    void begin(const char *section) { out_ << '$' << section << '\n'; }
    void end(const char *section) { out_ << "\n$End" << section << '\n'; }
    void integer(std::int32_t value) { put(value); }
    void size(std::size_t value) { put<std::uint64_t>(value); }
    void real(double value) { put(value); }
    void endRow() {}
    bool ok() const { return out_.ok(); }

  private:
    template <class Number>
    void put(Number value) {
        out_.bytes(&value, sizeof value);
    }

    TextWriter &out_;
};

template <class Rows>
void writePlace(Vec2 place, Rows &rows) {
    for (const double coordinate : {place.x, place.y, 0.0}) {
        rows.real(coordinate);
    }
}

template <class Rows>
void writeEntities(const MshModel &model, Rows &rows) {
    rows.begin("Entities");
    for (const std::size_t count : {model.count(0), model.count(1), model.count(2), std::size_t{0}}) {
        rows.size(count);
    }
    rows.endRow();
    for (const MshEntity &entity : model.entities()) {
        rows.integer(entity.tag);
        writePlace(entity.box.min, rows);
        if (entity.dimension > 0) { // a point has its position instead of a box
            writePlace(entity.box.max, rows);
        }
        rows.size(1);
        rows.integer(entity.physical);
        if (entity.dimension > 0) {
            rows.size(entity.bounds.size());
            for (const std::int32_t curve : entity.bounds) {
                rows.integer(curve);
            }
        }
        rows.endRow();
    }
    rows.end("Entities");
}

/// Writes the first row of a section: number of blocks, number of items, minimum and maximum number.
template <class Rows>
void writeHead(std::size_t blocks, std::size_t count, Rows &rows) {
    for (const std::size_t number : {blocks, count, std::size_t{count > 0 ? 1U : 0U}, count}) {
        rows.size(number);
    }
    rows.endRow();
}

/// Writes the first row of a block: the entity, a number and how many items follow.
template <class Rows>
void writeBlockHead(const MshEntity &entity, int number, std::size_t count, Rows &rows) {
    rows.integer(entity.dimension);
    rows.integer(entity.tag);
    rows.integer(number);
    rows.size(count);
    rows.endRow();
}

template <class Rows>
void writeNodes(const MeshView &mesh, const MshModel &model, Rows &rows) {
    const std::size_t blocks = model.nodeBlocks();
    rows.begin("Nodes");
    writeHead(blocks, blocks > 0 ? mesh.nodes.size() : 0, rows);
    for (const MshEntity &entity : model.entities()) {
        if (entity.nodes.empty()) {
            continue;
        }
        writeBlockHead(entity, 0, entity.nodes.size(), rows);
        for (const std::uint32_t node : entity.nodes) {
            rows.size(node + std::size_t{1});
            rows.endRow();
        }
        for (std::size_t k = 0; k < entity.nodes.size() && rows.ok(); ++k) {
            writePlace(mesh.nodes[entity.nodes[k]], rows);
            rows.endRow();
        }
    }
    rows.end("Nodes");
}

template <class Rows>
void writeElements(const MeshView &mesh, const MshModel &model, Rows &rows) {
    rows.begin("Elements");
    writeHead(model.cellBlocks(), mesh.points.size() + mesh.edges.size() + mesh.elementCount(), rows);
    for (const MshEntity &entity : model.entities()) {
        for (const MshRun &run : entity.runs) {
            writeBlockHead(entity, traitsOf(run.kind).gmsh, run.end - run.begin, rows);
            for (std::size_t k = run.begin; k < run.end && rows.ok(); ++k) {
                const std::uint32_t part = entity.parts[k];
                rows.size(model.firstNumber(entity.dimension) + part);
                model.forEachNode(entity.dimension, part,
                                  [&](NodeId node) { rows.size(index(node) + std::size_t{1}); });
                rows.endRow();
            }
        }
    }
    rows.end("Elements");
}

template <class Rows>
void writeSections(const MeshView &mesh, const ExportOptions &options, TextWriter &out,
                   void (*writeValues)(const MeshView &, TextWriter &)) {
    const MshGroups groups(mesh, options.keepTags);
    const MshModel model(mesh, groups);
    Rows rows(out);
    groups.writeNames(out);
    writeEntities(model, rows);
    writeNodes(mesh, model, rows);
    writeElements(mesh, model, rows);
    const auto curve = [&](std::int32_t tag) {
        const std::int32_t group = groups.number(1, tag);
        const auto found = std::find_if(model.entities().begin(), model.entities().end(), [&](const MshEntity &entity) {
            return entity.dimension == 1 && entity.physical == group;
        });
        return found->tag;
    };
    writeMsh4Periodic(mesh, curve, rows);
    writeValues(mesh, out);
    groups.writeOrigins(out, options.unit);
}

/// Writes the elevations of a mesh as writeMshElevations() does, the values in binary.
void writeBinaryElevations(const MeshView &mesh, TextWriter &out) {
    if (mesh.elevations.empty()) {
        return;
    }
    out << "$NodeData\n1\n\"elevation\"\n1\n0\n3\n0\n1\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        const auto number = static_cast<std::int32_t>(n + 1);
        out.bytes(&number, sizeof number).bytes(&mesh.elevations[n], sizeof(double));
    }
    out << "\n$EndNodeData\n";
}

} // namespace

void writeMsh4With(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    writeSections<TextRows>(mesh, options, out, writeMshElevations);
}

void writeMsh4BinaryWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    out << "$MeshFormat\n4.1 1 8\n";
    BinaryRows(out).integer(1); // shows the byte order
    out << "\n$EndMeshFormat\n";
    writeSections<BinaryRows>(mesh, options, out, writeBinaryElevations);
}

void writeMsh4(const MeshView &mesh, TextWriter &out) {
    writeMsh4With(mesh, {}, out);
}

void writeMsh4Binary(const MeshView &mesh, TextWriter &out) {
    writeMsh4BinaryWith(mesh, {}, out);
}

} // namespace forefront
