#include "ui/panels/adapted_rounds.hpp"

#include "core/edit/spacing_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"

#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr const char *kErrorField = "estimated error";

/// Logs how an adaptation ended.
void logEnd(Shell &context) {
    const AdaptProgress &now = context.adaptation.now();
    if (!now.faults.empty()) {
        context.log.add(now.faults);
    }
    if (now.rounds.empty()) {
        return;
    }
    const AdaptedMesh &last = *now.rounds.back();
    std::string text = "Adapted: mesh " + std::to_string(now.rounds.size() - 1) + " has " +
                       ui::count(last.mesh.elements.size()) + " triangles";
    if (last.error) {
        text += ", estimated error " + ui::number(100.0 * *last.error, 3) + " %";
    } else {
        text += "; compute the field on it, and adapt again if the error is still too large";
    }
    if (now.stalled) {
        text += "; finer meshes do not reduce it: check whether the field has a jump";
    } else if (!now.met && last.error && now.faults.empty()) {
        text += "; to meet the target, allow more rounds or a smaller minimum size";
    }
    context.log.announce(text);
}

/// Returns true if the canvas shows a mesh of the adaptation, or the mesh that it starts from.
bool showsRounds(const Shell &context) {
    const std::shared_ptr<const MeshView> &mesh = context.run.now().mesh;
    return context.adaptation.shown == 0 || (mesh && mesh->version == context.adaptation.shown);
}

} // namespace

bool followAdaptation(Shell &context) {
    Adaptation &adaptation = context.adaptation;
    const bool any = adaptation.busy() || !adaptation.now().rounds.empty();
    if (any && adaptation.loads != context.document.loads()) {
        adaptation.clear();
        return true;
    }
    if (!adaptation.refresh()) {
        return false;
    }
    const std::size_t rounds = adaptation.now().rounds.size();
    if (rounds > adaptation.followed) {
        const bool newest = adaptation.followed == 0 || adaptation.selected + 1 == adaptation.followed;
        if (newest && showsRounds(context)) {
            showRound(context, rounds - 1);
        }
        adaptation.followed = rounds;
    }
    if (!adaptation.busy()) {
        logEnd(context);
    }
    return true;
}

void showRound(Shell &context, std::size_t round) {
    Adaptation &adaptation = context.adaptation;
    const AdaptedMesh &adapted = *adaptation.now().rounds[round];
    MeshFields fields{adapted.mesh, {}, {}};
    if (adapted.error) {
        fields.fields[adaptation.request().field] = adapted.values;
        fields.elementFields[kErrorField] = adapted.errors;
    }
    context.run.showFile(std::move(fields));
    adaptation.selected = round;
    adaptation.shown = context.run.now().mesh->version;
    showLayer(context.layers, "quality", true);
    if (adapted.error) {
        chooseField(context, MeshPart::Elements, kErrorField);
    } else {
        chooseMeasure(context, Measure::ShapeFactor);
    }
    context.animate();
}

void keepSpacing(Shell &context, std::size_t round) {
    Result<Document> next = setSpacing(*context.document.current(), context.adaptation.now().rounds[round]->spacing);
    if (!next) {
        context.log.add(next.faults());
        return;
    }
    context.document.apply(*std::move(next), "Keep adapted spacing");
    context.log.announce("The drawing now has the spacing of mesh " + std::to_string(round) +
                         "; press 2 to mesh it again");
}

} // namespace forefront
