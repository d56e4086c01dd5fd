#include "ui/tools/common/region_menu.hpp"

#include "core/drawing/names/region_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/current_faces.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/mark_region.hpp"

#include <string>
#include <utility>

namespace forefront {
namespace {

void selectMarker(Shell &context, std::uint32_t marker) {
    context.selection.clear();
    context.selection.markers.insert(marker);
    context.animate();
}

/// Returns the commands on a region that has a marker.
ContextGroup markerMenu(const Shell &context, std::uint32_t marker) {
    const Document &document = *context.document.current();
    ContextGroup group{headingOf("Region " + regionName(document.regionNames, document.regionMarkers[marker].tag))};
    group.push_back(commandOf("region/rename", "Rename region\xe2\x80\xa6", [marker](Shell &c) {
        c.naming.openOnCanvas({.kind = NamedThing::Kind::Region, .marker = marker}, c.menu.at, c.document);
    }));
    group.push_back(commandOf("region/size", "Element size of region\xe2\x80\xa6", [marker](Shell &c) {
        selectMarker(c, marker);
        c.actions.run("edit.setSize", c);
    }));
    group.push_back(commandOf("region/select", "Select region", [marker](Shell &c) {
        c.tools.choose("select", c);
        selectMarker(c, marker);
    }));
    group.push_back(commandOf("region/delete", "Delete region", [marker](Shell &c) {
        if (c.applyCommand(removeRegionMarker(*c.document.current(), marker), "Delete region")) {
            c.selection.markers.clear(); // their numbers have changed
        }
    }));
    return group;
}

} // namespace

ContextGroup regionMenu(const Shell &context, Vec2 place, bool makes, std::int32_t next) {
    const std::shared_ptr<const FaceMap> faces = currentFaces(context);
    const std::uint32_t face = faces->faceAt(place);
    if (face == kNoIndex) {
        return {};
    }
    const std::uint32_t marker = faces->faces()[face].marker;
    if (marker < context.document.current()->regionMarkers.size()) {
        return markerMenu(context, marker);
    }
    if (!makes) {
        return {};
    }
    const std::string name = regionName(context.document.current()->regionNames, next);
    return {commandOf("region/make", "Make this face region " + name,
                      [place, next](Shell &c) { markRegion(c, place, next); })};
}

} // namespace forefront
