#include "core/drawing_files/svg/areas/svg_roles.hpp"

#include "core/drawing_files/svg/xml/svg_names.hpp"

#include <string_view>
#include <utility>

namespace forefront {

namespace {

bool isLoop(const SvgPath &path) {
    return path.closed && path.nodes.size() > 2;
}

} // namespace

SvgRoles::SvgRoles(const SourceText &source, std::span<const SvgPath> paths, bool cropsFill)
    : source_(source), anyPainted_(cropsFill) {
    for (const SvgPath &path : paths) {
        anyPainted_ = anyPainted_ || path.covers();
        anyStroked_ = anyStroked_ || (path.paint.stroked && path.nodes.size() > 1);
    }
}

PathRole SvgRoles::of(const SvgPath &path) const {
    if (path.painted()) {
        return PathRole::Painted;
    }
    if (path.strokeArea) {
        return PathRole::Stroke;
    }
    if (path.nodes.size() < 2) {
        return PathRole::Nothing;
    }
    const bool loop = isLoop(path);
    if (loop && !path.paint.stroked && (anyPainted_ || anyStroked_)) {
        return PathRole::Nothing;
    }
    if (!anyPainted_) {
        return loop ? PathRole::Outline : PathRole::Line;
    }
    return source_.options.dropLines ? PathRole::LeftOut : PathRole::Line;
}

void SvgRoles::noteReading(const SvgPath &path, PathRole role) {
    const bool first = std::exchange(noted_, path.element) != path.element;
    if (!first || path.nodes.size() < 2) {
        return;
    }
    if (role == PathRole::Outline) {
        source_.note("svg-outlines",
                     "nothing is filled: closed lines are outlines, and a closed line inside another is a hole",
                     path.offset);
    } else if (role == PathRole::Nothing) {
        source_.note("svg-unpainted",
                     "shapes with neither fill nor stroke are ignored, because other shapes have a fill or stroke; an "
                     "outline needs one",
                     path.offset);
    } else if (role == PathRole::Line && isLoop(path)) {
        source_.note("svg-unfilled",
                     "shapes without fill are read as lines, because other shapes are filled; "
                     "--drop-lines leaves them out",
                     path.offset);
    } else if (role == PathRole::LeftOut) {
        source_.note("dropped-lines", "lines are left out", path.offset);
        return;
    }
    if (path.drawnAsLine() && path.nodes.size() > 2) {
        source_.note("svg-polyline",
                     "polylines with a stroke and the default fill are read as lines, although renderers fill them",
                     path.offset);
    }
    if (!path.paint.stroked || role == PathRole::Nothing) {
        return;
    }
    if (!(path.paint.line.width > 0.0)) {
        source_.note("svg-zero-stroke", "strokes of width 0 are read as lines, although renderers paint nothing",
                     path.offset);
    } else if (!path.strokeArea) {
        source_.note(kStrokeNote,
                     source_.options.strokeAreas
                         ? "strokes that do not scale with the drawing are read as lines"
                         : "strokes are not meshed: shapes end at the middle of their stroke; --stroke-areas "
                           "meshes their painted area",
                     path.offset);
    }
}

void SvgRoles::noteMerged(std::span<const SvgPath> paths) const {
    std::string_view name;
    for (const SvgPath &path : paths) {
        if (!path.painted() || isGeneratedName(path.name)) {
            continue;
        }
        if (!name.empty() && path.name != name) {
            source_.note("svg-regions",
                         "filled shapes with different names are one region; --shape-regions makes each a region",
                         path.offset);
            return;
        }
        name = path.name;
    }
}

} // namespace forefront
