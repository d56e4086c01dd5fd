#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing_files/project/project.hpp"
#include "core/drawing_files/project/project_constraints.hpp"
#include "core/drawing_files/project/project_cracks.hpp"
#include "core/drawing_files/project/project_curves.hpp"
#include "core/drawing_files/project/project_element_counts.hpp"
#include "core/drawing_files/project/project_layers.hpp"
#include "core/drawing_files/project/project_mapped.hpp"
#include "core/drawing_files/project/project_node_sizes.hpp"
#include "core/drawing_files/project/project_periodic.hpp"
#include "core/drawing_files/project/project_picture.hpp"
#include "core/drawing_files/project/project_region_elements.hpp"
#include "core/drawing_files/project/project_spacing.hpp"
#include "core/drawing_files/project/project_strips.hpp"
#include "core/drawing_files/project/project_water.hpp"
#include "core/drawing_files/project/project_words.hpp"
#include "core/files/json/json.hpp"
#include "core/files/json/json_text.hpp"
#include "core/files/rules/rules_json.hpp"
#include "core/files/text/atomic_file.hpp"

#include <utility>

namespace forefront {

namespace {

using Names = std::map<std::int32_t, std::string>;

/// Writes the members of one project.
class ProjectWriter {
  public:
    /// `file`: of the project; empty: paths are written as they are.
    explicit ProjectWriter(TextWriter &out, std::filesystem::path file = {}) : file_(std::move(file)), out_(out) {}

    void write(const Document &document) {
        out_ << "{\n  \"format\": \"forefront\",\n  \"version\": " << kProjectVersion;
        shapes(document);
        writeConstraints(document, out_);
        regionMarkers(document.regionMarkers);
        names("boundaryNames", document.boundaryNames);
        names("regionNames", document.regionNames);
        writeSpacing(rulesOf(document), out_);
        writeElementCounts(document, out_);
        writeLayers(document, out_);
        writePeriodic(document, out_);
        writeCracks(document, out_);
        writeWater(document, out_);
        writeMapped(document, out_);
        writeStrips(document, out_);
        writeRegionElements(document, out_);
        options(document.options);
        limits(document.limits);
        out_ << ",\n  \"circleTolerance\": ";
        out_.number(document.circleTolerance);
        if (document.curveTolerance != 0.0) {
            out_ << ",\n  \"curveTolerance\": ";
            out_.number(document.curveTolerance);
        }
        parameters(document);
        if (document.picture) {
            writePicture(*document.picture, file_, out_);
        }
        guides(document.guides);
        if (document.unit != LengthUnit::None) {
            out_ << ",\n  \"unit\": \"" << wordOf(document.unit) << '"';
        }
        out_ << ",\n  \"nextId\": " << document.nextId << "\n}\n";
    }

  private:
    /// Returns the radius of a form that has one; 0 for others.
    static double radiusOf(const Shape &shape) {
        return shape.visit([](const PathForm &) { return 0.0; },
                           [](const RectangleForm &rectangle) { return rectangle.radius; },
                           [](const CircleForm &) { return 0.0; }, [](const PointForm &) { return 0.0; },
                           [](const EllipseForm &) { return 0.0; }, [](const SlotForm &slot) { return slot.radius; });
    }

    void shapes(const Document &document) {
        out_ << ",\n  \"shapes\": [\n    ";
        out_.list(document.shapes, ",\n    ", [&](const std::shared_ptr<const Shape> &shape) {
            out_ << "{\"id\": " << shape->id << ", \"kind\": \"" << wordOf(shape->kind()) << "\", \"use\": \""
                 << wordOf(shape->use) << "\", \"tag\": " << shape->tag << ", \"name\": " << jsonString(shape->name)
                 << ", \"nodes\": [";
            out_.list(shape->nodes, ", ", [&](Vec2 p) { out_.point(p); });
            out_ << ']';
            if (!shape->segmentTags.empty()) {
                out_ << ", \"segmentTags\": [";
                out_.list(shape->segmentTags, ", ", [&](std::int32_t tag) { out_ << tag; });
                out_ << ']';
            }
            if (const double radius = radiusOf(*shape); radius != 0.0) {
                out_ << ", \"radius\": ";
                out_.number(radius);
            }
            writeCurves(*shape, out_);
            writeNodeSizes(*shape, out_);
            writeSegmentSizes(*shape, out_);
            out_ << (shape->hidden ? ", \"hidden\": true" : "") << (shape->locked ? ", \"locked\": true" : "")
                 << (shape->construction ? ", \"construction\": true" : "");
            if (shape->group != 0) {
                out_ << ", \"group\": " << shape->group;
            }
            out_ << '}';
        });
        out_ << "\n  ]";
    }

    void guides(const std::vector<Guide> &guides) {
        if (guides.empty()) {
            return;
        }
        out_ << ",\n  \"guides\": [";
        out_.list(guides, ", ", [&](const Guide &guide) {
            out_ << (guide.upright ? "{\"x\": " : "{\"y\": ");
            out_.number(guide.at);
            out_ << '}';
        });
        out_ << ']';
    }

    void regionMarkers(const std::vector<MarkedRegion> &markers) {
        out_ << ",\n  \"regionMarkers\": [";
        out_.list(markers, ", ", [&](const MarkedRegion &marker) {
            out_ << "{\"at\": ";
            out_.point(marker.at);
            out_ << ", \"tag\": " << marker.tag;
            if (marker.maxArea != 0.0) {
                out_ << ", \"maxArea\": ";
                out_.number(marker.maxArea);
            }
            if (marker.size != 0.0) {
                out_ << ", \"size\": ";
                out_.number(marker.size);
                out_ << ", \"growth\": ";
                out_.number(marker.growth);
            }
            out_ << '}';
        });
        out_ << ']';
    }

    void names(const char *member, const Names &names) {
        out_ << ",\n  \"" << member << "\": {";
        out_.list(names, ", ",
                  [&](const auto &entry) { out_ << '"' << entry.first << "\": " << jsonString(entry.second); });
        out_ << '}';
    }

    void options(const MeshingOptions &options) {
        out_ << ",\n  \"options\": {\"method\": \"" << wordOf(options.method) << "\", \"grid\": \""
             << wordOf(options.grid) << "\", \"gridColumns\": " << options.gridColumns
             << ", \"gridRows\": " << options.gridRows
             << ", \"keepBoundary\": " << (options.keepBoundary ? "true" : "false") << ", \"improve\": \""
             << wordOf(options.improve) << "\", \"threads\": " << options.threads;
        const MeshingOptions usual;
        if (options.elements != usual.elements) {
            out_ << ", \"elements\": \"" << wordOf(options.elements) << '"';
        }
        if (options.order != usual.order) {
            out_ << ", \"order\": " << wordOf(options.order);
        }
        if (options.quadNodes != usual.quadNodes) {
            out_ << ", \"quadNodes\": " << wordOf(options.quadNodes);
        }
        if (options.leastAngle) {
            out_ << ", \"leastAngle\": " << *options.leastAngle;
        }
        if (options.maxElements != kDefaultMaxElements) {
            out_ << ", \"maxElements\": " << options.maxElements;
        }
        if (options.rules != FrontRules()) {
            out_ << ", \"rules\": ";
            writeRules(options.rules, out_);
        }
        out_ << '}';
    }

    /// Writes the parameters in order, and the formulas by address.
    void parameters(const Document &document) {
        if (!document.parameters.empty()) {
            out_ << ",\n  \"parameters\": {";
            out_.list(document.parameters, ", ", [&](const Parameter &parameter) {
                out_ << jsonString(parameter.name) << ": " << jsonString(parameter.expression);
            });
            out_ << '}';
        }
        if (!document.formulas.empty()) {
            out_ << ",\n  \"formulas\": {";
            std::map<std::string, std::string> formulas; // in the order of their texts, which files have always had
            for (const auto &[address, text] : document.formulas) {
                formulas.emplace(toString(address), text);
            }
            out_.list(formulas, ", ", [&](const auto &formula) {
                out_ << jsonString(formula.first) << ": " << jsonString(formula.second);
            });
            out_ << '}';
        }
    }

    void limits(const MeshLimits &limits) {
        if (!limits.any()) {
            return;
        }
        out_ << ",\n  \"limits\": {";
        const char *separator = "";
        for (const MeshLimit limit : valuesOf<MeshLimit>()) {
            if (limits[limit]) {
                out_ << separator << '"' << limitInfo(limit).member << "\": ";
                out_.number(*limits[limit]);
                separator = ", ";
            }
        }
        out_ << '}';
    }

    std::filesystem::path file_;
    JsonText out_;
};

} // namespace

std::string projectFileText(const std::filesystem::path &path, const Document &document) {
    StringSink sink;
    TextWriter out(sink);
    ProjectWriter(out, path).write(document);
    out.flush();
    return std::move(sink.text);
}

std::string projectText(const Document &document) {
    return projectFileText({}, document);
}

Status writeProject(const std::filesystem::path &path, const Document &document) {
    if (document.spacing.hasFunction()) {
        Diagnostics fault = error("not-storable", "the size function of the spacing cannot be saved in a project file",
                                  "replace it with an expression, or with sizes on a grid (SizeGrid)");
        fault.front().file = path.string();
        return fault;
    }
    return writeTextFile(path, [&](TextWriter &out) { ProjectWriter(out, path).write(document); });
}

} // namespace forefront
