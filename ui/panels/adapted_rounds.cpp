#include "ui/panels/adapted_rounds.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
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
    const std::size_t made = now.rounds.size() - 1;
    std::string text = "mesh " + std::to_string(made) + " has " + ui::count(last.mesh.elements.size()) + " triangles";
    if (last.error) {
        text += ", estimated error " + ui::number(100.0 * *last.error, 3) + " %";
    }
    if (!now.faults.empty()) {
        if (made > 0) {
            context.log.refuse("Adapting ended early; " + text);
        }
        return;
    }
    if (!last.error) {
        text += "; compute the field on it, and adapt again if the error is still too large";
    } else if (now.stalled) {
        text += "; finer meshes do not reduce it: check whether the field has a jump";
    } else if (!now.met) {
        text += "; to meet the target, allow more rounds or a smaller minimum size";
    }
    context.log.announce("Adapted: " + text);
}

/// Returns true if the canvas shows a mesh of the adaptation, or the mesh that it starts from, and no run is about to
/// replace it.
bool showsRounds(const Shell &context) {
    const std::shared_ptr<const MeshSnapshot> &mesh = context.run.now().mesh;
    const bool follows =
        !context.run.showsFile() && (context.run.busy() || context.run.hasNews() || context.run.liveMeshPending());
    return mesh && mesh->version == context.adaptation.shown && !follows;
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
    const AdaptRequest &request = adaptation.request();
    if (round == 0 && request.mesh == request.source.mesh && request.source.fields) {
        fields.fields = request.source.fields->nodes;
        fields.elementFields = request.source.fields->elements;
    }
    if (adapted.error) {
        fields.fields[request.field] = adapted.values;
        fields.elementFields[kErrorField] = adapted.errors;
    }
    context.run.showAdapted(std::move(fields));
    adaptation.selected = round;
    adaptation.shown = context.run.now().mesh->version;
    showMeshColours(context);
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
