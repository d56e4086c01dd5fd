#include "core/io/gmsh/gmsh.hpp"
#include "core/io/gmsh/msh_model.hpp"

#include <array>
#include <bit>

namespace forefront {

namespace {

static_assert(std::endian::native == std::endian::little, "binary MSH is written in the byte order of the machine");

template <class T>
void put(TextWriter &out, T value) {
    out.bytes(&value, sizeof value);
}

/// Collects numbers and writes them in blocks.
template <class T>
class RowBuffer {
  public:
    explicit RowBuffer(TextWriter &out) : out_(out) {}
    ~RowBuffer() { flush(); }
    RowBuffer(const RowBuffer &) = delete;
    RowBuffer &operator=(const RowBuffer &) = delete;

    void add(T value) {
        values_[used_++] = value;
        if (used_ == values_.size()) {
            flush();
        }
    }

  private:
    void flush() {
        out_.bytes(values_.data(), used_ * sizeof(T));
        used_ = 0;
    }

    TextWriter &out_;
    std::array<T, 4096> values_;
    std::size_t used_ = 0;
};

/// Writes the head of a section: number of blocks, number of items, minimum and maximum number.
void putHead(TextWriter &out, std::size_t blocks, std::size_t count) {
    for (const std::size_t number : {blocks, count, std::size_t{count > 0 ? 1U : 0U}, count}) {
        put<std::uint64_t>(out, number);
    }
}

void writeEntities(const MshModel &model, TextWriter &out) {
    out << "$Entities\n";
    for (const std::size_t count : {model.count(0), model.count(1), model.count(2), std::size_t{0}}) {
        put<std::uint64_t>(out, count);
    }
    for (const MshEntity &entity : model.entities()) {
        put<std::int32_t>(out, entity.tag);
        for (const Vec2 corner : {entity.box.min, entity.box.max}) {
            for (const double coordinate : {corner.x, corner.y, 0.0}) {
                put(out, coordinate);
            }
            if (entity.dimension == 0) {
                break; // a point has its position instead of a box
            }
        }
        put<std::uint64_t>(out, 1);
        put<std::int32_t>(out, entity.physical);
        if (entity.dimension > 0) {
            put<std::uint64_t>(out, entity.bounds.size());
            for (const std::int32_t curve : entity.bounds) {
                put(out, curve);
            }
        }
    }
    out << "\n$EndEntities\n";
}

void writeNodes(const Mesh &mesh, const MshModel &model, TextWriter &out) {
    const std::size_t blocks = model.nodeBlocks();
    out << "$Nodes\n";
    putHead(out, blocks, blocks > 0 ? mesh.nodes.size() : 0);
    for (const MshEntity &entity : model.entities()) {
        if (entity.nodes.empty() || !out.ok()) {
            continue;
        }
        for (const std::int32_t number : {entity.dimension, entity.tag, 0}) {
            put(out, number);
        }
        put<std::uint64_t>(out, entity.nodes.size());
        {
            RowBuffer<std::uint64_t> numbers(out);
            for (const std::uint32_t node : entity.nodes) {
                numbers.add(node + std::uint64_t{1});
            }
        }
        RowBuffer<double> places(out);
        for (const std::uint32_t node : entity.nodes) {
            places.add(mesh.nodes[node].x);
            places.add(mesh.nodes[node].y);
            places.add(0.0);
        }
    }
    out << "\n$EndNodes\n";
}

void writeElements(const Mesh &mesh, const MshModel &model, TextWriter &out) {
    out << "$Elements\n";
    putHead(out, model.entities().size(), mesh.points.size() + mesh.edges.size() + mesh.elements.size());
    for (const MshEntity &entity : model.entities()) {
        if (!out.ok()) {
            return;
        }
        for (const std::int32_t number : {entity.dimension, entity.tag, entity.elementType()}) {
            put(out, number);
        }
        put<std::uint64_t>(out, entity.parts.size());
        RowBuffer<std::uint64_t> rows(out);
        for (const std::uint32_t part : entity.parts) {
            rows.add(model.firstNumber(entity.dimension) + part);
            const Element nodes = model.nodesOf(entity.dimension, part);
            for (std::size_t k = 0; k < entity.cornerCount(); ++k) {
                rows.add(index(nodes[k]) + std::uint64_t{1});
            }
        }
    }
    out << "\n$EndElements\n";
}

} // namespace

/// Writes MSH 4.1, binary. Integers have four bytes, counts and the numbers of nodes and elements eight. Section names
/// and names of physical groups stay text.
void writeMsh4Binary(const Mesh &mesh, TextWriter &out) {
    const MshGroups groups(mesh);
    const MshModel model(mesh, groups);
    out << "$MeshFormat\n4.1 1 8\n";
    put<std::int32_t>(out, 1);
    out << "\n$EndMeshFormat\n";
    groups.writeNames(out);
    writeEntities(model, out);
    writeNodes(mesh, model, out);
    writeElements(mesh, model, out);
    groups.writeOrigins(out);
}

} // namespace forefront
