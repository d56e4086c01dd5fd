#include "core/io/json/json.hpp"
#include "core/io/project/project.hpp"
#include "core/io/project/project_words.hpp"
#include "core/io/project/tile_code.hpp"
#include "core/io/text/atomic_file.hpp"

#include <cmath>

namespace forefront {

namespace {

using Names = std::map<std::int32_t, std::string>;

/// Writes the members of one project. A number that JSON cannot hold is written as null, which the reader refuses with
/// its place.
class ProjectWriter {
  public:
    explicit ProjectWriter(TextWriter &out) : out_(out) {}

    void write(const Document &document) {
        out_ << "{\n  \"format\": \"forefront\",\n  \"version\": " << kProjectVersion;
        shapes(document);
        regionMarkers(document.regionMarkers);
        names("boundaryNames", document.boundaryNames);
        names("regionNames", document.regionNames);
        spacing(document.spacing);
        options(document.options);
        out_ << ",\n  \"circleTolerance\": ";
        number(document.circleTolerance);
        out_ << ",\n  \"nextId\": " << document.nextId << "\n}\n";
    }

  private:
    void number(double value) {
        if (std::isfinite(value)) {
            out_ << value;
        } else {
            out_ << "null";
        }
    }
    void point(Vec2 p) {
        out_ << '[';
        number(p.x);
        out_ << ", ";
        number(p.y);
        out_ << ']';
    }
    template <class Range, class Write>
    void list(const Range &range, const char *separator, Write write) {
        bool first = true;
        for (const auto &item : range) {
            out_ << (first ? "" : separator);
            first = false;
            write(item);
        }
    }

    void shapes(const Document &document) {
        out_ << ",\n  \"shapes\": [\n    ";
        list(document.shapes, ",\n    ", [&](const std::shared_ptr<const Shape> &shape) {
            out_ << "{\"id\": " << shape->id << ", \"kind\": \"" << wordOf(shape->kind) << "\", \"use\": \""
                 << wordOf(shape->use) << "\", \"tag\": " << shape->tag << ", \"name\": " << jsonString(shape->name)
                 << ", \"nodes\": [";
            list(shape->nodes, ", ", [&](Vec2 p) { point(p); });
            out_ << ']';
            if (!shape->segmentTags.empty()) {
                out_ << ", \"segmentTags\": [";
                list(shape->segmentTags, ", ", [&](std::int32_t tag) { out_ << tag; });
                out_ << ']';
            }
            out_ << '}';
        });
        out_ << "\n  ]";
    }

    void regionMarkers(const std::vector<RegionMarker> &markers) {
        out_ << ",\n  \"regionMarkers\": [";
        list(markers, ", ", [&](const RegionMarker &marker) {
            out_ << "{\"at\": ";
            point(marker.at);
            out_ << ", \"tag\": " << marker.tag;
            if (marker.maxArea != 0.0) {
                out_ << ", \"maxArea\": ";
                number(marker.maxArea);
            }
            out_ << '}';
        });
        out_ << ']';
    }

    void names(const char *member, const Names &names) {
        out_ << ",\n  \"" << member << "\": {";
        list(names, ", ", [&](const auto &entry) { out_ << '"' << entry.first << "\": " << jsonString(entry.second); });
        out_ << '}';
    }

    void optional(const char *member, const std::optional<double> &value) {
        if (value) {
            out_ << ",\n    \"" << member << "\": ";
            number(*value);
        }
    }

    void spacing(const SpacingSpec &spec) {
        out_ << ",\n  \"spacing\": {\n    \"fromBoundary\": " << (spec.fromBoundary ? "true" : "false");
        optional("size", spec.size);
        optional("minimum", spec.minimum);
        optional("maximum", spec.maximum);
        optional("gradation", spec.gradation);
        if (spec.expression) {
            out_ << ",\n    \"expression\": " << jsonString(*spec.expression);
        }
        if (!spec.sources.empty()) {
            out_ << ",\n    \"sources\": [\n      ";
            list(spec.sources, ",\n      ", [&](const SizeSource &item) { source(item); });
            out_ << "\n    ]";
        }
        if (!spec.paint.tiles.empty()) {
            paint(spec.paint);
        }
        if (spec.background) {
            background(*spec.background);
        }
        out_ << "\n  }";
    }

    void source(const SizeSource &source) {
        out_ << "{\"shape\": \"" << wordOf(source.shape) << "\", \"a\": ";
        point(source.a);
        out_ << ", \"b\": ";
        point(source.b);
        out_ << ", \"radius\": ";
        number(source.radius);
        out_ << ", \"size\": ";
        number(source.size);
        out_ << ", \"growth\": ";
        number(source.growth);
        out_ << ", \"name\": " << jsonString(source.name) << '}';
    }

    void paint(const PaintedSpacing &paint) {
        out_ << ",\n    \"paint\": {\n      \"origin\": ";
        point(paint.origin);
        out_ << ",\n      \"pitch\": ";
        number(paint.pitch);
        out_ << ",\n      \"tiles\": [\n        ";
        list(paint.tiles, ",\n        ", [&](const auto &entry) {
            out_ << '[' << entry.first.first << ", " << entry.first.second << ", \"" << encodeTile(*entry.second)
                 << "\"]";
        });
        out_ << "\n      ]\n    }";
    }

    void background(const BackgroundMesh &mesh) {
        out_ << ",\n    \"background\": {\n      \"nodes\": [";
        list(mesh.nodes, ", ", [&](Vec2 p) { point(p); });
        out_ << "],\n      \"elements\": [";
        list(mesh.elements, ", ", [&](const auto &e) { out_ << '[' << e[0] << ", " << e[1] << ", " << e[2] << ']'; });
        out_ << "],\n      \"values\": [";
        list(mesh.values, ", ", [&](double value) { number(value); });
        out_ << "]\n    }";
    }

    void options(const MeshingOptions &options) {
        out_ << ",\n  \"options\": {\"method\": \"" << wordOf(options.method) << "\", \"grid\": \""
             << wordOf(options.grid) << "\", \"gridColumns\": " << options.gridColumns
             << ", \"gridRows\": " << options.gridRows
             << ", \"keepBoundary\": " << (options.keepBoundary ? "true" : "false") << ", \"improve\": \""
             << wordOf(options.improve) << "\", \"threads\": " << options.threads << '}';
    }

    TextWriter &out_;
};

} // namespace

std::string projectText(const Document &document) {
    StringSink sink;
    TextWriter out(sink);
    ProjectWriter(out).write(document);
    out.flush();
    return std::move(sink.text);
}

Status writeProject(const std::filesystem::path &path, const Document &document) {
    return writeTextFile(path, [&](TextWriter &out) { ProjectWriter(out).write(document); });
}

} // namespace forefront
