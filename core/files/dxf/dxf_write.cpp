#include "core/files/dxf/dxf_write.hpp"

#include "core/files/common/edge_chains.hpp"
#include "core/files/common/names.hpp"
#include "core/files/common/tagged_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kLongestLayer = 31; // bytes of a name in R12
constexpr double kFlat = 1e-12;           ///< of the size: distance of nodes from a side that they lie on

FileNames layersOf(const TagList &tags) {
    UniqueNames unique;
    FileNames layers;
    const auto add = [&unique](const auto &from, auto &to) {
        for (const auto &[tag, name] : from) {
            to.emplace(tag, unique.claim(asIdentifier(name, kLongestLayer), kLongestLayer));
        }
    };
    add(tags.edges, layers.edges);
    add(tags.regions, layers.regions);
    add(tags.points, layers.points);
    return layers;
}

/// Returns the value of $INSUNITS for a unit.
int insUnitsOf(LengthUnit unit) {
    constexpr std::array<int, wordsOf<LengthUnit>().size()> kInsUnits = {0, 4, 5, 6, 7, 1, 2};
    return kInsUnits[static_cast<std::size_t>(unit)];
}

/// A vertex of a polyline, with the bulge of the segment after it: the tangent of a quarter of its angle.
struct DxfVertex {
    Vec2 at;
    double bulge = 0.0;
};

/// Writes the groups of R12: header, table of layers, entities.
class DxfWriter {
  public:
    DxfWriter(const MeshView &mesh, bool outline, LengthUnit unit, TextWriter &out)
        : mesh_(mesh), outline_(outline), unit_(unit), out_(out), layers_(layersOf(tagsOf(mesh))),
          size_(mesh.bounds().diagonal()) {}

    void write() {
        group(0, "SECTION").group(2, "HEADER").group(9, "$ACADVER").group(1, "AC1009");
        if (unit_ != LengthUnit::None) {
            group(9, "$INSUNITS").group(70, insUnitsOf(unit_)); // newer than R12, but programs read it there as well
        }
        group(0, "ENDSEC");
        writeLayers();
        group(0, "SECTION").group(2, "ENTITIES");
        if (!outline_) {
            writeElements();
        }
        writeEdges();
        for (const TaggedNode &point : mesh_.points) {
            group(0, "POINT").group(8, layers_.points.at(point.tag));
            place(0, mesh_.nodes[index(point.node)]);
        }
        group(0, "ENDSEC").group(0, "EOF");
    }

  private:
    template <class Value>
    DxfWriter &group(int code, const Value &value) {
        out_ << code << '\n' << value << '\n';
        return *this;
    }

    void place(int number, Vec2 at) { group(10 + number, at.x).group(20 + number, at.y).group(30 + number, 0); }

    void writeLayers() {
        constexpr int kWhite = 7, kGrey = 8;
        const std::size_t count =
            layers_.edges.size() + layers_.points.size() + (outline_ ? 0 : layers_.regions.size());
        group(0, "SECTION").group(2, "TABLES").group(0, "TABLE").group(2, "LAYER").group(70, count + 1);
        layer("0", kWhite);
        for (const auto &[tag, name] : layers_.regions) {
            if (!outline_) {
                layer(name, kGrey);
            }
        }
        for (const auto *names : {&layers_.edges, &layers_.points}) {
            for (const auto &[tag, name] : *names) {
                layer(name, 1 + static_cast<int>(static_cast<std::uint32_t>(tag - 1) % 6U)); // red to magenta
            }
        }
        group(0, "ENDTAB").group(0, "ENDSEC");
    }

    void layer(const std::string &name, int colour) {
        group(0, "LAYER").group(2, name).group(70, 0).group(62, colour).group(6, "CONTINUOUS");
    }

    void writeElements() {
        for (std::size_t k = 0; k < mesh_.elementCount() && out_.ok(); ++k) {
            const std::span<const NodeId> corners = mesh_.cornersOf(k);
            group(0, "3DFACE").group(8, layers_.regions.at(mesh_.region(k)));
            for (int c = 0; c < 4; ++c) { // of a triangle, the last corner twice
                const auto corner = std::min(static_cast<std::size_t>(c), corners.size() - 1);
                place(c, mesh_.nodes[index(corners[corner])]);
            }
        }
    }

    void writeEdges() {
        std::map<std::int32_t, std::vector<std::uint32_t>> byTag;
        for (std::uint32_t e = 0; e < mesh_.edges.size(); ++e) {
            byTag[mesh_.edges[e].tag].push_back(e);
            ofEnds_[ends(mesh_.edges[e].a, mesh_.edges[e].b)] = e;
        }
        for (const auto &[tag, edges] : byTag) {
            for (const EdgeChain &chain : joinEdges(mesh_, edges)) {
                writeChain(chain, layers_.edges.at(tag));
            }
        }
    }

    using Ends = std::pair<NodeId, NodeId>;
    static Ends ends(NodeId a, NodeId b) { return {std::min(a, b), std::max(a, b)}; }

    /// Returns the stretch of the curve that an edge follows, from a to b.
    CurveStretch stretchOf(NodeId a, NodeId b) const {
        const auto found = ofEnds_.find(ends(a, b));
        if (found == ofEnds_.end() || found->second >= mesh_.edgeStretches.size()) {
            return {};
        }
        const CurveStretch &stretch = mesh_.edgeStretches[found->second];
        return mesh_.edges[found->second].a == a ? stretch : stretch.reversed();
    }

    /// A part of a chain that one segment or one curve follows.
    struct Run {
        Vec2 from, to;
        CurveStretch stretch;
    };

    std::vector<Run> runsOf(const EdgeChain &chain) const {
        std::vector<Run> runs;
        std::size_t step = 1;
        for (std::size_t k = 0; k + step < chain.nodes.size(); k += step) {
            const NodeId a = chain.nodes[k];
            step = k + 2 < chain.nodes.size() && !ofEnds_.contains(ends(a, chain.nodes[k + 1])) ? 2 : 1; // of 3 nodes
            const NodeId b = chain.nodes[k + step];
            const CurveStretch stretch = outline_ ? stretchOf(a, b) : CurveStretch{};
            const Vec2 from = mesh_.nodes[index(a)], to = mesh_.nodes[index(b)];
            if (step == 2 && !stretch.follows()) {
                const Vec2 middle = mesh_.nodes[index(chain.nodes[k + 1])];
                runs.push_back({from, middle, {}});
                runs.push_back({middle, to, {}});
            } else if (outline_ && !runs.empty() && continues(runs.back(), stretch, to)) {
                runs.back().to = to;
                runs.back().stretch.t1 = stretch.t1;
            } else {
                runs.push_back({from, to, stretch});
            }
        }
        return runs;
    }

    bool continues(const Run &run, const CurveStretch &next, Vec2 to) const {
        if (next.curve != run.stretch.curve) {
            return false;
        }
        if (next.follows()) {
            return next.t0 == run.stretch.t1 && (next.t1 > next.t0) == (run.stretch.t1 > run.stretch.t0);
        }
        const Vec2 before = run.to - run.from, after = to - run.to;
        return dot(before, after) > 0.0 &&
               std::fabs(cross(to - run.from, before)) <= kFlat * size_ * length(to - run.from);
    }

    void writeChain(const EdgeChain &chain, const std::string &layer) {
        std::vector<DxfVertex> vertices;
        const std::vector<Run> runs = runsOf(chain);
        for (const Run &run : runs) {
            append(run, vertices);
        }
        if (!chain.closed()) {
            vertices.push_back({runs.back().to, 0.0});
        }
        group(0, "POLYLINE").group(8, layer).group(66, 1);
        place(0, {});
        group(70, chain.closed() ? 1 : 0);
        for (const DxfVertex &vertex : vertices) {
            group(0, "VERTEX").group(8, layer);
            place(0, vertex.at);
            if (vertex.bulge != 0.0) {
                group(42, vertex.bulge);
            }
        }
        group(0, "SEQEND").group(8, layer);
    }

    /// Appends the vertices of a run but its last.
    void append(const Run &run, std::vector<DxfVertex> &vertices) const {
        vertices.push_back({run.from, 0.0});
        if (!run.stretch.follows()) {
            return;
        }
        const Curve &curve = mesh_.curves[run.stretch.curve];
        const double t0 = run.stretch.t0, t1 = run.stretch.t1;
        if (const double turn = turnOf(curve, t0, t1); turn != 0.0) {
            constexpr double kMaxTurn = 3.0; // radians; bulges of full turns do not exist
            const auto parts = static_cast<int>(std::ceil(std::fabs(turn) / kMaxTurn));
            for (int k = 0; k < parts; ++k) {
                if (k > 0) {
                    vertices.push_back({curve.point(t0 + (t1 - t0) * k / parts), 0.0});
                }
                vertices.back().bulge = std::tan(turn / parts / 4.0);
            }
            return;
        }
        const Curve part = curve.part(t0, t1);
        for (const double t : part.flatten(kDxfTolerance * size_)) {
            if (t < 1.0) {
                vertices.push_back({part.point(t), 0.0});
            }
        }
    }

    /// Returns the angle of a circular arc, in radians, counter-clockwise; 0 for other curves.
    static double turnOf(const Curve &curve, double t0, double t1) {
        constexpr double kRound = 1e-12; // relative difference of the axes
        if (curve.kind() != CurveKind::Arc) {
            return 0.0;
        }
        const std::array<double, 8> n = curve.numbers();
        const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
        const double square = dot(u, u);
        const bool circular =
            std::fabs(dot(v, v) - square) <= kRound * square && std::fabs(dot(u, v)) <= kRound * square;
        return circular ? (t1 - t0) * n[7] * (cross(u, v) > 0.0 ? 1.0 : -1.0) : 0.0;
    }

    const MeshView &mesh_;
    bool outline_;
    LengthUnit unit_;
    TextWriter &out_;
    FileNames layers_;
    double size_;
    std::map<Ends, std::uint32_t> ofEnds_; ///< edges by their nodes
};

} // namespace

void writeDxf(const MeshView &mesh, TextWriter &out) {
    writeDxfWith(mesh, {}, out);
}

void writeDxfWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    DxfWriter(mesh, false, options.unit, out).write();
}

void writeDxfOutline(const MeshView &mesh, TextWriter &out) {
    writeDxfOutlineWith(mesh, {}, out);
}

void writeDxfOutlineWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out) {
    DxfWriter(mesh, true, options.unit, out).write();
}

Diagnostics noteDxfChanges(const MeshView &mesh) {
    const TagList tags = tagsOf(mesh);
    return noteChangedNames(tags, layersOf(tags));
}

} // namespace forefront
