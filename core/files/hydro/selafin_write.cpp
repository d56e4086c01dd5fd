#include "core/engine/base/letter_case.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/shoreline.hpp"
#include "core/files/common/tagged_cells.hpp"
#include "core/files/hydro/selafin.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

/// Coordinates up to this one keep a centimetre in single precision.
constexpr double kFarFromOrigin = 1e5;

/// Writes the records of a Fortran file: their length before and after them, all numbers with the highest byte first.
class FortranRecords {
  public:
    explicit FortranRecords(TextWriter &out) : out_(out) {}

    void text(std::string_view text, std::size_t width) {
        integer(static_cast<std::uint32_t>(width));
        out_ << text.substr(0, width) << std::string(width - std::min(width, text.size()), ' ');
        integer(static_cast<std::uint32_t>(width));
    }
    /// Writes a record of `count` numbers of 4 bytes.
    template <class Value>
    void numbers(std::size_t count, Value value) {
        integer(static_cast<std::uint32_t>(4 * count));
        for (std::size_t k = 0; k < count && out_.ok(); ++k) {
            if constexpr (std::is_floating_point_v<decltype(value(k))>) {
                integer(std::bit_cast<std::uint32_t>(static_cast<float>(value(k))));
            } else {
                integer(static_cast<std::uint32_t>(value(k)));
            }
        }
        integer(static_cast<std::uint32_t>(4 * count));
    }

  private:
    void integer(std::uint32_t value) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            out_ << static_cast<char>(value >> shift & 0xffU);
        }
    }

    TextWriter &out_;
};

/// Returns the whole number of units that the origin moves along an axis, so that coordinates become small. `shortest`:
/// of the edges, for which rounding to single precision must be small.
std::int32_t shiftOf(double low, double high, double shortest) {
    const double middle = std::floor(0.5 * (low + high));
    const double farthest = std::max(std::fabs(low), std::fabs(high));
    constexpr double kRounding = 0x1p-24, kSmall = 1e-3;
    const bool far = farthest > kFarFromOrigin || kRounding * farthest > kSmall * shortest;
    return far && std::fabs(middle) < 2e9 ? static_cast<std::int32_t>(middle) : 0;
}

double shortestEdge(const MeshView &mesh) {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const NodeId next = corners[(k + 1) % corners.size()];
            shortest = std::min(shortest, distance(mesh.nodes[index(corners[k])], mesh.nodes[index(next)]));
        }
    }
    return shortest;
}

struct Shift {
    std::int32_t x, y;
};

Shift shiftOf(const MeshView &mesh) {
    const Box2 box = mesh.bounds();
    const double shortest = shortestEdge(mesh);
    return {shiftOf(box.min.x, box.max.x, shortest), shiftOf(box.min.y, box.max.y, shortest)};
}

/// Returns the nodes of the boundary, loop by loop: around the mesh, then around islands. Fault: not-manifold, if the
/// boundary touches itself at a node.
Result<std::vector<NodeId>> boundaryNodes(const MeshView &mesh) {
    std::vector<NodeId> nodes;
    std::vector<std::uint8_t> seen(mesh.nodes.size(), 0);
    for (const ShoreStretch &stretch : shoreline(mesh, {})) {
        const bool closed = stretch.kind != ShoreStretch::Kind::Island; // its first node comes again
        for (std::size_t k = 0; k + (closed ? 1 : 0) < stretch.nodes.size(); ++k) {
            const NodeId node = stretch.nodes[k];
            if (seen[index(node)] != 0) {
                Diagnostics faults =
                    error("not-manifold", "the boundary touches itself at a node, which TELEMAC does not "
                                          "allow");
                faults.front().at = mesh.nodes[index(node)];
                return faults;
            }
            seen[index(node)] = 1;
            nodes.push_back(node);
        }
    }
    return nodes;
}

void writeGeometry(const MeshView &mesh, std::span<const NodeId> shore, TextWriter &out) {
    const Shift shift = shiftOf(mesh);
    std::vector<std::uint32_t> numbers(mesh.nodes.size(), 0); // 0: within
    for (std::size_t k = 0; k < shore.size(); ++k) {
        numbers[index(shore[k])] = static_cast<std::uint32_t>(k + 1);
    }
    const std::size_t nodes = mesh.nodes.size(), elements = mesh.elementCount();
    FortranRecords records(out);
    records.text(
        std::string(titleOf(mesh)) + std::string(72 - std::string_view(titleOf(mesh)).size(), ' ') + "SERAFIN ", 80);
    records.numbers(2, [](std::size_t k) { return k == 0 ? 1 : 0; });
    records.text("BOTTOM          M               ", 32);
    records.numbers(10, [&](std::size_t k) { return k == 0 ? 1 : k == 2 ? shift.x : k == 3 ? shift.y : 0; });
    records.numbers(4, [&](std::size_t k) { return k == 0 ? elements : k == 1 ? nodes : k == 2 ? 3 : 1; });
    records.numbers(3 * elements, [&](std::size_t k) { return index(mesh.nodesOf(k / 3)[k % 3]) + 1; });
    records.numbers(nodes, [&](std::size_t n) { return numbers[n]; });
    records.numbers(nodes, [&](std::size_t n) { return mesh.nodes[n].x - shift.x; });
    records.numbers(nodes, [&](std::size_t n) { return mesh.nodes[n].y - shift.y; });
    records.numbers(1, [](std::size_t) { return 0.0; });
    records.numbers(nodes, [&](std::size_t n) { return mesh.elevation(n); });
}

/// Writes the conditions of the boundary nodes: a wall is 2 2 2, an open part, with a prescribed level, 5 4 4.
void writeConditions(const MeshView &mesh, const ExportOptions &options, std::span<const NodeId> shore,
                     TextWriter &out) {
    std::vector<std::uint8_t> open(mesh.nodes.size(), 0);
    for (const ShoreStretch &stretch : shoreline(mesh, options.openBoundaries)) {
        for (const NodeId node : stretch.nodes) {
            open[index(node)] |= stretch.kind == ShoreStretch::Kind::Open ? 1 : 0;
        }
    }
    for (std::size_t k = 0; k < shore.size() && out.ok(); ++k) {
        const bool isOpen = open[index(shore[k])] != 0;
        out << (isOpen ? "5 4 4" : "2 2 2") << " 0. 0. 0. 0. " << (isOpen ? '4' : '2') << " 0. 0. 0. "
            << index(shore[k]) + 1 << ' ' << k + 1 << '\n';
    }
}

} // namespace

Status writeSelafin(FileSet &files, const std::filesystem::path &path, const MeshView &mesh,
                    const ExportOptions &options, const Progress &progress) {
    const Result<std::vector<NodeId>> shore = boundaryNodes(mesh);
    if (!shore) {
        return shore.faults();
    }
    std::filesystem::path geometry = path, conditions = path;
    if (lowerCase(path.extension().string()) != kSelafinExtensions[0]) {
        geometry.replace_extension(kSelafinExtensions[0]);
    }
    conditions.replace_extension(kSelafinExtensions[1]);
    files.write(
        geometry, [&](TextWriter &out) { writeGeometry(mesh, *shore, out); }, progress);
    files.write(
        conditions, [&](TextWriter &out) { writeConditions(mesh, options, *shore, out); }, progress);
    return files.status();
}

Diagnostics noteSelafinChanges(const MeshView &mesh) {
    Diagnostics notes;
    const auto add = [&](const char *code, std::string message) {
        Diagnostic &note = notes.emplace_back();
        note.severity = Severity::Note;
        note.code = code;
        note.message = std::move(message);
    };
    if (mesh.elevations.empty()) {
        add("no-elevation", "the bottom is 0 at all nodes: the mesh has no elevations");
    }
    const Shift shift = shiftOf(mesh);
    if (shift.x != 0 || shift.y != 0) {
        add("moved-origin", "coordinates are single precision from the origin (" + std::to_string(shift.x) + ", " +
                                std::to_string(shift.y) + "), which the file holds");
    }
    return notes;
}

} // namespace forefront
