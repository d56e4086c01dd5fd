#include "ui/panels/source_growth.hpp"

#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

namespace forefront {

bool drawSourceGrowth(Shell &context, SizeSource &source, const NumberAddress &address) {
    bool changed = false;
    if (source.shape == SourceShape::Line) {
        form::label(context, "");
        changed = ui::checkbox(context, "inspector/plane", "Over the whole plane", source.plane);
        ui::rowTooltip(
            context,
            "A gradient: the size changes from one end of the line to the other across the whole plane, and is "
            "constant beyond each end.");
    }
    if (!source.plane) {
        return form::number(context, "inspector/growth", "Growth", source.growth, address) || changed;
    }
    form::label(context, "");
    changed = ui::checkbox(context, "inspector/geometric", "By equal factors", source.geometric) || changed;
    ui::rowTooltip(context, "The size grows by equal factors over equal distances; otherwise by equal amounts.");
    return changed;
}

} // namespace forefront
