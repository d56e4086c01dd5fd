#include "core/drawing_files/project/project_spacing.hpp"

#include "core/drawing_files/project/project_rasters.hpp"
#include "core/drawing_files/project/tile_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

void writeSources(const std::vector<SizeSource> &sources, JsonText &out) {
    out << "[\n      ";
    out.list(sources, ",\n      ", [&](const SizeSource &source) {
        out << "{\"shape\": \"" << wordOf(source.shape) << "\", \"a\": ";
        out.point(source.a);
        out << ", \"b\": ";
        out.point(source.b);
        out << ", \"radius\": ";
        out.number(source.radius);
        out << ", \"size\": ";
        out.number(source.size);
        if (source.endSize) {
            out << ", \"endSize\": ";
            out.number(*source.endSize);
        }
        if (source.plane) {
            out << ", \"plane\": true";
        }
        if (source.geometric) {
            out << ", \"geometric\": true";
        }
        out << ", \"growth\": ";
        out.number(source.growth);
        if (source.angle != 0.0) {
            out << ", \"angle\": ";
            out.number(source.angle);
        }
        out << ", \"name\": " << jsonString(source.name) << '}';
    });
    out << "\n    ]";
}

SizeSource readSource(const JsonValue &item, JsonCheck &check) {
    SizeSource source;
    if (const auto shape = check.member(item, "shape", "the source")) {
        source.shape = static_cast<SourceShape>(check.choice(*shape, wordsOf<SourceShape>(), "the shape of a source"));
    }
    if (const auto a = check.member(item, "a", "the source")) {
        source.a = check.point(*a, "a source");
    }
    const bool needsB = source.shape == SourceShape::Box;
    if (const auto b = needsB ? check.member(item, "b", "the box source") : item.find("b")) {
        source.b = check.point(*b, "a source");
    }
    if (const auto angle = item.find("angle")) {
        source.angle = check.number(*angle, "the angle of a source");
    }
    if (const auto radius = item.find("radius")) {
        source.radius = check.notNegative(*radius, "the radius of a source");
    }
    if (const auto size = check.member(item, "size", "the source")) {
        source.size = check.positive(*size, "the size of a source");
    }
    if (const auto size = item.find("endSize")) {
        source.endSize = check.positive(*size, "the size at the second end of a source");
    }
    if (const auto growth = item.find("growth")) {
        source.growth = check.notNegative(*growth, "the growth of a source");
    }
    if (const auto name = item.find("name")) {
        source.name = check.string(*name, "the name of a source");
    }
    if (const auto plane = item.find("plane")) {
        source.plane = check.flag(*plane, "\"plane\" of a source");
    }
    if (const auto geometric = item.find("geometric")) {
        source.geometric = check.flag(*geometric, "\"geometric\" of a source");
    }
    check.noteUnknown(
        item, {"shape", "a", "b", "radius", "size", "endSize", "plane", "geometric", "growth", "angle", "name"});
    return source;
}

std::vector<SizeSource> readSources(const JsonValue &list, JsonCheck &check) {
    std::vector<SizeSource> sources;
    if (check.expect(list, JsonKind::Array, "\"sources\"")) {
        for (const JsonValue item : list) {
            if (check.full()) {
                break;
            }
            sources.push_back(readSource(item, check));
        }
    }
    return sources;
}

void writePartSizes(const std::map<std::int32_t, PartSize> &sizes, JsonText &out) {
    out << "[\n      ";
    out.list(sizes, ",\n      ", [&](const auto &entry) {
        out << "{\"tag\": " << entry.first << ", \"size\": ";
        out.number(entry.second.size);
        out << ", \"growth\": ";
        out.number(entry.second.growth);
        out << '}';
    });
    out << "\n    ]";
}

void readPartSize(const JsonValue &item, JsonCheck &check, std::map<std::int32_t, PartSize> &sizes) {
    if (!check.expect(item, JsonKind::Object, "a size of a boundary part")) {
        return;
    }
    PartSize part;
    std::int32_t tag = 1;
    if (const auto value = check.member(item, "tag", "the size of a boundary part")) {
        tag = check.tag(*value);
    }
    if (const auto value = check.member(item, "size", "the size of a boundary part")) {
        part.size = check.positive(*value, "the size of a boundary part");
    }
    if (const auto value = item.find("growth")) {
        part.growth = check.notNegative(*value, "the growth of a boundary part");
    }
    check.noteUnknown(item, {"tag", "size", "growth"});
    if (!sizes.emplace(tag, part).second) {
        check.fault(item, "bad-tag", "tag " + std::to_string(tag) + " already has a size");
    }
}

std::map<std::int32_t, PartSize> readPartSizes(const JsonValue &list, JsonCheck &check) {
    std::map<std::int32_t, PartSize> sizes;
    if (check.expect(list, JsonKind::Array, "\"partSizes\"")) {
        for (const JsonValue item : list) {
            if (check.full()) {
                break;
            }
            readPartSize(item, check, sizes);
        }
    }
    return sizes;
}

void writePaint(const PaintedSpacing &paint, JsonText &out) {
    out << "{\n      \"origin\": ";
    out.point(paint.origin);
    out << ",\n      \"pitch\": ";
    out.number(paint.pitch);
    if (paint.replaces) {
        out << ",\n      \"replaces\": true";
    }
    out << ",\n      \"tiles\": [\n        ";
    out.list(paint.tiles, ",\n        ", [&](const auto &entry) {
        out << '[' << entry.first.first << ", " << entry.first.second << ", \"" << encodeTile(*entry.second) << "\"]";
    });
    out << "\n      ]\n    }";
}

void readTile(const JsonValue &item, JsonCheck &check, PaintedSpacing &paint) {
    constexpr std::int64_t kMaxInt = std::numeric_limits<std::int32_t>::max();
    if (!item.is(JsonKind::Array) || item.count() != 3) {
        check.fault(item, "bad-tile", "expected [column, row, \"values\"] for a painted tile");
        return;
    }
    auto field = item.begin();
    const std::int64_t column = check.integer(*field, -kMaxInt, kMaxInt, "the column of a painted tile");
    ++field;
    const std::int64_t row = check.integer(*field, -kMaxInt, kMaxInt, "the row of a painted tile");
    ++field;
    const auto values = decodeTile((*field).string());
    const bool sound = values && std::all_of(values->begin(), values->end(),
                                             [](float value) { return std::isfinite(value) && value >= 0.0F; });
    if (!sound) {
        check.fault(*field, "bad-tile", "the values of this painted tile are damaged");
        return;
    }
    const std::pair place(static_cast<std::int32_t>(column), static_cast<std::int32_t>(row));
    if (!paint.tiles.emplace(place, std::make_shared<const PaintedSpacing::Tile>(*values)).second) {
        check.fault(item, "bad-tile", "duplicate painted tile");
    }
}

PaintedSpacing readPaint(const JsonValue &object, JsonCheck &check) {
    PaintedSpacing paint;
    if (!check.expect(object, JsonKind::Object, "\"paint\"")) {
        return paint;
    }
    if (const auto origin = check.member(object, "origin", "the paint")) {
        paint.origin = check.point(*origin, "the origin of the paint");
    }
    if (const auto pitch = check.member(object, "pitch", "the paint")) {
        paint.pitch = check.positive(*pitch, "the pitch of the paint");
    }
    if (const auto replaces = object.find("replaces")) {
        paint.replaces = check.flag(*replaces, "\"replaces\" of the paint");
    }
    check.noteUnknown(object, {"origin", "pitch", "replaces", "tiles"});
    const auto tiles = check.member(object, "tiles", "the paint");
    if (!tiles || !check.expect(*tiles, JsonKind::Array, "\"tiles\"")) {
        return paint;
    }
    for (const JsonValue item : *tiles) {
        if (check.full()) {
            break;
        }
        readTile(item, check, paint);
    }
    return paint;
}

void writeBackground(const BackgroundMesh &mesh, JsonText &out) {
    out << "{\n      \"nodes\": [";
    out.list(mesh.nodes, ", ", [&](Vec2 p) { out.point(p); });
    out << "],\n      \"elements\": [";
    out.list(mesh.elements, ", ", [&](const auto &e) { out << '[' << e[0] << ", " << e[1] << ", " << e[2] << ']'; });
    out << "],\n      \"values\": [";
    out.list(mesh.values, ", ", [&](double value) { out.number(value); });
    out << "]\n    }";
}

std::array<std::uint32_t, 3> readBackgroundElement(const JsonValue &item, std::size_t nodes, JsonCheck &check) {
    std::array<std::uint32_t, 3> element{};
    std::size_t count = 0;
    for (const JsonValue node : item) {
        const auto number = node.integer();
        if (!number || *number < 0 || static_cast<std::size_t>(*number) >= nodes) {
            check.fault(node, "bad-index",
                        "expected the index of a node, from 0 to less than " + std::to_string(nodes));
        } else if (count < 3) {
            element[count] = static_cast<std::uint32_t>(*number);
        }
        ++count;
    }
    if (!item.is(JsonKind::Array) || count != 3) {
        check.fault(item, "bad-count", "expected 3 node indices for an element");
    }
    return element;
}

std::shared_ptr<const BackgroundMesh> readBackground(const JsonValue &object, JsonCheck &check) {
    if (!check.expect(object, JsonKind::Object, "\"background\"")) {
        return nullptr;
    }
    const auto nodes = check.member(object, "nodes", "the background mesh");
    const auto elements = check.member(object, "elements", "the background mesh");
    const auto values = check.member(object, "values", "the background mesh");
    if (!nodes || !elements || !values || !check.expect(*nodes, JsonKind::Array, "\"nodes\"") ||
        !check.expect(*elements, JsonKind::Array, "\"elements\"") ||
        !check.expect(*values, JsonKind::Array, "\"values\"")) {
        return nullptr;
    }
    check.noteUnknown(object, {"nodes", "elements", "values"});
    BackgroundMesh mesh;
    mesh.nodes = check.points(*nodes, "a node of the background mesh");
    for (const JsonValue item : *elements) {
        if (check.full()) {
            return nullptr;
        }
        mesh.elements.push_back(readBackgroundElement(item, mesh.nodes.size(), check));
    }
    for (const JsonValue value : *values) {
        if (check.full()) {
            return nullptr;
        }
        mesh.values.push_back(check.positive(value, "a spacing of the background mesh"));
    }
    if (mesh.values.size() != mesh.nodes.size()) {
        check.fault(*values, "bad-count",
                    "expected one spacing for each of the " + std::to_string(mesh.nodes.size()) + " nodes, found " +
                        std::to_string(mesh.values.size()));
    }
    return std::make_shared<const BackgroundMesh>(std::move(mesh));
}

using OptionalNumber = std::optional<double> SpacingSpec::*;

/// A member of the object "spacing".
struct SpacingMember {
    const char *name;
    bool (*given)(const SpacingSpec &);
    void (*write)(const SpacingSpec &, JsonText &);
    /// `name` as above, for messages.
    void (*read)(const JsonValue &, JsonCheck &, std::string_view name, SpacingSpec &);
};

/// A number > 0, or >= 0 if `zero` may be given.
template <OptionalNumber target, bool zero = false>
constexpr SpacingMember numberMember(const char *name) {
    return {name, [](const SpacingSpec &spec) { return (spec.*target).has_value(); },
            [](const SpacingSpec &spec, JsonText &out) { out.number(*(spec.*target)); },
            [](const JsonValue &value, JsonCheck &check, std::string_view memberName, SpacingSpec &spec) {
                spec.*target = zero ? check.notNegative(value, memberName) : check.positive(value, memberName);
            }};
}

/// One entry for each member, in the order of the file.
constexpr std::array kMembers = {
    SpacingMember{"fromBoundary", [](const SpacingSpec &) { return true; },
                  [](const SpacingSpec &spec, JsonText &out) { out << (spec.fromBoundary ? "true" : "false"); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.fromBoundary = check.flag(value, "\"fromBoundary\"");
                  }},
    numberMember<&SpacingSpec::size>("size"),
    numberMember<&SpacingSpec::minimum>("minimum"),
    numberMember<&SpacingSpec::maximum>("maximum"),
    numberMember<&SpacingSpec::gradation>("gradation"),
    numberMember<&SpacingSpec::segmentsPerTurn, true>("segmentsPerTurn"),
    numberMember<&SpacingSpec::elementsAcross, true>("elementsAcross"),
    SpacingMember{"expression", [](const SpacingSpec &spec) { return spec.expression.has_value(); },
                  [](const SpacingSpec &spec, JsonText &out) { out << jsonString(*spec.expression); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.expression = check.string(value, "\"expression\"");
                  }},
    SpacingMember{"rasters", [](const SpacingSpec &spec) { return !spec.rasters.empty(); },
                  [](const SpacingSpec &spec, JsonText &out) { writeRasters(spec.rasters, out); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.rasters = readRasters(value, check);
                  }},
    SpacingMember{"sources", [](const SpacingSpec &spec) { return !spec.sources.empty(); },
                  [](const SpacingSpec &spec, JsonText &out) { writeSources(spec.sources, out); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.sources = readSources(value, check);
                  }},
    SpacingMember{"keepAutomatic", [](const SpacingSpec &spec) { return spec.keepAutomatic.has_value(); },
                  [](const SpacingSpec &spec, JsonText &out) { out << (*spec.keepAutomatic ? "true" : "false"); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.keepAutomatic = check.flag(value, "\"keepAutomatic\"");
                  }},
    SpacingMember{"partSizes", [](const SpacingSpec &spec) { return !spec.partSizes.empty(); },
                  [](const SpacingSpec &spec, JsonText &out) { writePartSizes(spec.partSizes, out); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.partSizes = readPartSizes(value, check);
                  }},
    SpacingMember{"paint", [](const SpacingSpec &spec) { return !spec.paint.tiles.empty(); },
                  [](const SpacingSpec &spec, JsonText &out) { writePaint(spec.paint, out); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.paint = readPaint(value, check);
                  }},
    SpacingMember{"background", [](const SpacingSpec &spec) { return spec.background != nullptr; },
                  [](const SpacingSpec &spec, JsonText &out) { writeBackground(*spec.background, out); },
                  [](const JsonValue &value, JsonCheck &check, std::string_view, SpacingSpec &spec) {
                      spec.background = readBackground(value, check);
                  }},
};

} // namespace

void writeSpacing(const SpacingSpec &spec, JsonText &out) {
    out << ",\n  \"spacing\": {";
    const char *separator = "\n    \"";
    for (const SpacingMember &member : kMembers) {
        if (member.given(spec)) {
            out << separator << member.name << "\": ";
            member.write(spec, out);
            separator = ",\n    \"";
        }
    }
    out << "\n  }";
}

SpacingSpec readSpacing(const JsonValue &object, JsonCheck &check) {
    SpacingSpec spec;
    for (const SpacingMember &member : kMembers) {
        if (const auto value = object.find(member.name); value && !check.full()) {
            member.read(*value, check, member.name, spec);
        }
    }
    std::vector<std::string_view> known;
    known.reserve(kMembers.size());
    for (const SpacingMember &member : kMembers) {
        known.emplace_back(member.name);
    }
    check.noteUnknown(object, known);
    return spec;
}

} // namespace forefront
