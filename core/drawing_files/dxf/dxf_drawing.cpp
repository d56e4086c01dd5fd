#include "core/drawing_files/dxf/dxf_drawing.hpp"

#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing_files/dxf/dxf_groups.hpp"
#include "core/drawing_files/dxf/dxf_spline.hpp"
#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace forefront {

namespace {

constexpr double kRadians = std::numbers::pi / 180.0;
constexpr std::size_t kMaxEntities = 20'000'000; ///< with those that inserts repeat
constexpr std::size_t kMaxDepth = 64;            ///< of blocks in blocks

/// Returns what the entities of a type are called in a note.
std::string kindOf(std::string_view type) {
    const auto isOneOf = [type](std::initializer_list<std::string_view> list) {
        return std::find(list.begin(), list.end(), type) != list.end();
    };
    if (isOneOf({"TEXT", "MTEXT", "ATTRIB", "ATTDEF"})) {
        return "texts";
    }
    if (isOneOf({"DIMENSION", "LEADER", "MULTILEADER", "TOLERANCE", "ARC_DIMENSION"})) {
        return "dimensions";
    }
    if (isOneOf({"3DFACE", "3DSOLID", "BODY", "REGION", "SURFACE", "MESH"})) {
        return "3D entities";
    }
    return type == "HATCH" ? "hatches" : type == "POINT" ? "points" : "entities of the type " + inQuotes(type);
}

/// Returns the arc of a circle that a bulge, the tangent of a quarter of its angle, puts over a chord.
Curve bulged(Vec2 a, Vec2 b, double bulge) {
    constexpr double kStraight = 1e-7; // rounding of the centre would exceed the height of a flatter arc
    const Vec2 chord = b - a;
    if (std::fabs(bulge) < kStraight || a == b) {
        return Curve::line(a, b);
    }
    const double height = (1.0 - bulge * bulge) / (4.0 * bulge);
    const Vec2 centre = 0.5 * (a + b) + height * Vec2{-chord.y, chord.x};
    const Vec2 u = a - centre;
    return Curve::arc(centre, u, {-u.y, u.x}, 0.0, 4.0 * std::atan(bulge));
}

/// The values of an entity's groups; of repeated groups, the last one.
struct Values {
    std::map<int, double> numbers;
    double of(int code, double otherwise) const {
        const auto found = numbers.find(code);
        return found == numbers.end() ? otherwise : found->second;
    }
    Vec2 point(int code) const { return {of(code, 0.0), of(code + 10, 0.0)}; }
    bool has(int code) const { return numbers.contains(code); }
};

bool isReal(int code) {
    return (code >= 10 && code < 60) || (code >= 210 && code < 240);
}

class Drawer {
  public:
    Drawer(const DxfFile &file, const SourceText &source) : file_(file), source_(source), faults_(source) {}

    Result<DxfPaths> run() {
        walk(file_.entities, {}, {});
        return faults_.ok() ? Result<DxfPaths>(std::move(drawn_)) : faults_.faults();
    }

  private:
    using Groups = std::vector<DxfGroup>;

    bool read(const DxfEntity &entity) {
        groups_.clear();
        values_.numbers.clear();
        layer_ = "0";
        DxfGroups reader(source_, entity.begin, entity.end);
        DxfGroup group;
        while (reader.next(group)) {
            if (group.code >= 999) { // comments and data of other programs
                continue;
            }
            groups_.push_back(group);
            if (group.code == 8) {
                layer_ = file_.encoding.name(group.value);
            } else if (isReal(group.code) || (group.code >= 60 && group.code < 80)) {
                const auto value = parseReal(group.value);
                if (!value || !std::isfinite(*value)) {
                    return faults_.fail(group.offset, "bad-number",
                                        "expected a number for group " + std::to_string(group.code) + " of " +
                                            std::string(entity.type) + ", found " + inQuotes(group.value));
                }
                values_.numbers[group.code] = *value;
                hasHeight_ = hasHeight_ || (group.code >= 30 && group.code < 39 && *value != 0.0);
            }
        }
        return true;
    }

    double number(const DxfGroup &group) const { return parseReal(group.value).value_or(0.0); }
    int flags() const { return static_cast<int>(std::clamp(values_.of(70, 0.0), 0.0, 65535.0)); }

    /// Returns true for an entity that is shown in the model.
    bool shown(std::size_t offset) {
        if (values_.of(67, 0.0) == 1.0) {
            source_.note("dxf-paper", "entities in paper space are left out", offset);
            return false;
        }
        if (values_.of(60, 0.0) == 1.0) {
            source_.note("dxf-hidden", "invisible entities are left out", offset);
            return false;
        }
        return true;
    }

    void walk(const std::vector<DxfEntity> &entities, const PlaneMap &map, const std::string &insertLayer) {
        for (std::size_t k = 0; k < entities.size() && faults_.ok(); ++k) {
            const DxfEntity &entity = entities[k];
            if (++visited_ > kMaxEntities) {
                faults_.fail(entity.begin, "too-large", "the inserted blocks have too many entities");
                return;
            }
            std::size_t last = k; // VERTEX entities follow a POLYLINE up to SEQEND
            while (entity.type == "POLYLINE" && last + 1 < entities.size() && entities[last + 1].type == "VERTEX") {
                ++last;
            }
            hasHeight_ = false;
            if (!read(entity)) {
                return;
            }
            if (!insertLayer.empty() && layer_ == "0") {
                layer_ = insertLayer;
            }
            if (entity.type != "SEQEND" && shown(entity.begin)) {
                draw(entity, entities, k, last, map);
            }
            k = last;
        }
    }

    /// Returns the map from the coordinates of an entity to the plane; none if it is tilted. Lines and splines are
    /// given in the coordinates of the model.
    std::optional<PlaneMap> frame(std::string_view type) const {
        if (type == "LINE" || type == "SPLINE") {
            return PlaneMap{};
        }
        const Vec2 tilt{values_.of(210, 0.0), values_.of(220, 0.0)};
        const double z = values_.of(230, 1.0);
        if (length(tilt) > 1e-9 * std::fabs(z)) {
            return std::nullopt;
        }
        return z < 0.0 ? PlaneMap::scaling({-1.0, 1.0}, {}) : PlaneMap{}; // by the arbitrary axis algorithm
    }

    void draw(const DxfEntity &entity, const std::vector<DxfEntity> &all, std::size_t k, std::size_t last,
              const PlaneMap &map) {
        const std::optional<PlaneMap> own = frame(entity.type);
        if (!own) {
            source_.note("dxf-left-out", "entities in tilted planes are left out", entity.begin);
            return;
        }
        if (!isComplete(entity)) {
            return;
        }
        std::vector<Curve> curves;
        bool closed = false, plane = true; // in coordinates of its own plane
        if (entity.type == "LINE") {
            curves.push_back(Curve::line(values_.point(10), values_.point(11)));
        } else if (entity.type == "CIRCLE" || entity.type == "ARC") {
            curves = arc(entity, closed);
        } else if (entity.type == "ELLIPSE") {
            curves = ellipse(entity, closed);
            plane = false;
        } else if (entity.type == "LWPOLYLINE" || entity.type == "POLYLINE") {
            const int flags = this->flags();
            if (entity.type == "POLYLINE" && (flags & (16 | 64)) != 0) {
                source_.note("dxf-left-out", "3D entities are left out", entity.begin);
                return;
            }
            closed = (flags & 1) != 0;
            plane = (flags & 8) == 0 || entity.type == "LWPOLYLINE";
            const std::string layer = layer_;
            curves = polyline(all, k, last, closed);
            layer_ = layer;
        } else if (entity.type == "SPLINE") {
            const DxfSpline spline = splineOf();
            if (const std::string fault = appendSpline(spline, curves); !fault.empty()) {
                faults_.fail(entity.begin, "bad-value", fault);
                return;
            }
        } else if (entity.type == "INSERT") {
            insert(entity, map.after(*own));
            return;
        } else {
            source_.note("dxf-left-out", kindOf(entity.type) + " are left out", entity.begin);
            return;
        }
        add(curves, closed, plane ? map.after(*own) : map, entity.begin);
    }

    /// Returns false, and refuses the file, if an entity lacks a coordinate without which it would be elsewhere.
    bool isComplete(const DxfEntity &entity) {
        const std::string_view type = entity.type;
        const bool line = type == "LINE", round = type == "CIRCLE" || type == "ARC" || type == "ELLIPSE";
        if (!line && !round) {
            return true;
        }
        for (const int code : {10, 20, 11, 21}) {
            const bool needed = code % 10 == 0 || line || type == "ELLIPSE";
            if (needed && !values_.has(code)) {
                return faults_.fail(entity.begin, "bad-value",
                                    "the " + std::string(type) + " has no group " + std::to_string(code) +
                                        ", a coordinate; expected groups 10 and 20" +
                                        (round && type != "ELLIPSE" ? "" : ", 11 and 21"));
            }
        }
        return true;
    }

    std::vector<Curve> arc(const DxfEntity &entity, bool &closed) const {
        closed = entity.type == "CIRCLE";
        const double r = values_.of(40, 0.0);
        if (!(r > 0.0)) {
            source_.note("dxf-left-out", "circles and arcs without a positive radius are left out", entity.begin);
            return {};
        }
        const double from = closed ? 0.0 : std::fmod(values_.of(50, 0.0), 360.0);
        double sweep = closed ? 360.0 : std::fmod(values_.of(51, 360.0) - from, 360.0);
        sweep += sweep <= 0.0 ? 360.0 : 0.0;
        return {Curve::arc(values_.point(10), {r, 0.0}, {0.0, r}, from * kRadians, sweep * kRadians)};
    }

    std::vector<Curve> ellipse(const DxfEntity &entity, bool &closed) const {
        constexpr double kFull = 2.0 * std::numbers::pi, kSame = 1e-9;
        const Vec2 major = values_.point(11);
        const double ratio = values_.of(40, 1.0), from = values_.of(41, 0.0);
        if (!(length(major) > 0.0 && ratio != 0.0)) {
            source_.note("dxf-left-out", "ellipses without extent are left out", entity.begin);
            return {};
        }
        double sweep = std::fmod(values_.of(42, kFull) - from, kFull);
        sweep += sweep <= kSame ? kFull : 0.0;
        closed = sweep >= kFull - kSame;
        const double turn = values_.of(230, 1.0) < 0.0 ? -1.0 : 1.0;
        return {
            Curve::arc(values_.point(10), major, turn * ratio * Vec2{-major.y, major.x}, from, closed ? kFull : sweep)};
    }

    std::vector<Curve> polyline(const std::vector<DxfEntity> &all, std::size_t k, std::size_t last, bool closed) {
        std::vector<Vec2> nodes;
        std::vector<double> bulges;
        const bool splined = (flags() & 4) != 0;
        if (all[k].type == "LWPOLYLINE") {
            for (const DxfGroup &group : groups_) {
                if (group.code == 10) {
                    nodes.push_back({number(group), 0.0});
                    bulges.push_back(0.0);
                } else if (group.code == 20 && !nodes.empty()) {
                    nodes.back().y = number(group);
                } else if (group.code == 42 && !nodes.empty()) {
                    bulges.back() = number(group);
                }
            }
        }
        for (std::size_t v = k + 1; v <= last && read(all[v]); ++v) {
            if (!(splined && (flags() & 16) != 0)) { // a control point of its spline
                nodes.push_back(values_.point(10));
                bulges.push_back(values_.of(42, 0.0));
            }
        }
        std::vector<Curve> curves;
        for (std::size_t n = 0; n + (closed ? 0 : 1) < nodes.size(); ++n) {
            curves.push_back(bulged(nodes[n], nodes[(n + 1) % nodes.size()], bulges[n]));
        }
        return curves;
    }

    DxfSpline splineOf() const {
        DxfSpline spline;
        spline.closed = (flags() & 1) != 0;
        spline.degree = static_cast<int>(std::clamp(values_.of(71, 3.0), 0.0, 1000.0));
        spline.startTangent = values_.point(12);
        spline.endTangent = values_.point(13);
        for (const DxfGroup &group : groups_) {
            std::vector<Vec2> &points = group.code % 10 == 0 ? spline.controls : spline.fits;
            if (group.code == 10 || group.code == 11) {
                points.push_back({number(group), 0.0});
            } else if ((group.code == 20 || group.code == 21) && !points.empty()) {
                points.back().y = number(group);
            } else if (group.code == 40) {
                spline.knots.push_back(number(group));
            } else if (group.code == 41) {
                spline.weights.push_back(number(group));
            }
        }
        return spline;
    }

    void insert(const DxfEntity &entity, const PlaneMap &map) {
        std::string name;
        for (const DxfGroup &group : groups_) {
            name = group.code == 2 ? dxfKey(file_, group.value) : name;
        }
        const auto block = file_.blocks.find(name);
        if (block == file_.blocks.end()) {
            source_.warn("dxf-block", "the file has no block " + inQuotes(name) + ": its inserts are left out",
                         entity.begin);
            return;
        }
        const auto known = file_.layers.find(lowerCase(layer_));
        if (!source_.options.layer && known != file_.layers.end() && known->second.frozen) {
            source_.note("dxf-layers", "blocks inserted on frozen layers are left out", entity.begin);
            return;
        }
        if (open_.size() >= kMaxDepth || !open_.insert(name).second) {
            faults_.fail(entity.begin, "nested-block",
                         "the block " + inQuotes(name) +
                             (open_.size() < kMaxDepth ? " contains itself" : " lies in too many others"));
            return;
        }
        if (block->second.external) {
            source_.note("dxf-left-out", "external references are left out", entity.begin);
        }
        const Values values = values_;
        const std::string layer = layer_;
        const PlaneMap turn = PlaneMap::rotation(values.of(50, 0.0), {});
        const PlaneMap scaled = turn.after(PlaneMap::scaling({values.of(41, 1.0), values.of(42, 1.0)}, {}));
        const PlaneMap inner = scaled.after(PlaneMap::translation(Vec2{} - block->second.base));
        const auto columns = std::max(1.0, values.of(70, 1.0)), rows = std::max(1.0, values.of(71, 1.0));
        for (double row = 0.0; row < rows && faults_.ok(); ++row) {
            for (double column = 0.0; column < columns && faults_.ok(); ++column) {
                if (++visited_ > kMaxEntities) {
                    faults_.fail(entity.begin, "too-large", "the inserted blocks have too many entities");
                }
                const Vec2 place = values.point(10) + turn({column * values.of(44, 0.0), row * values.of(45, 0.0)});
                walk(block->second.entities, map.after(PlaneMap::translation(place).after(inner)), layer);
            }
        }
        open_.erase(name);
    }

    void add(const std::vector<Curve> &curves, bool closed, const PlaneMap &map, std::size_t offset) {
        if (curves.empty() || !faults_.ok()) {
            return;
        }
        if (hasHeight_) {
            source_.note("dxf-height", "z coordinates are ignored: the drawing is seen from above", offset);
        }
        const auto [layer, added] =
            layers_.try_emplace(lowerCase(layer_), static_cast<std::uint32_t>(drawn_.layers.size()));
        if (added) {
            drawn_.layers.push_back(layer_);
        }
        drawn_.paths.push_back({drawn_.curves.size(), curves.size(), closed, layer->second, offset});
        for (const Curve &curve : curves) {
            drawn_.curves.push_back(curve.mapped(map));
            if (!drawn_.curves.back().finite()) {
                faults_.fail(offset, "bad-number", "the coordinates of an entity are too large");
            }
        }
    }

    const DxfFile &file_;
    const SourceText &source_;
    DxfGroups faults_;
    Groups groups_; ///< of the present entity
    Values values_; ///< of its groups
    std::string layer_;
    bool hasHeight_ = false;                      ///< one of its points has a z coordinate other than 0
    std::map<std::string, std::uint32_t> layers_; ///< by name in lower case
    std::set<std::string> open_;                  ///< blocks being inserted
    std::size_t visited_ = 0;
    DxfPaths drawn_;
};

} // namespace

Result<DxfPaths> drawDxf(const DxfFile &file, const SourceText &source) {
    return Drawer(file, source).run();
}

} // namespace forefront
