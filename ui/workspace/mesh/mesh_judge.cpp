#include "ui/workspace/mesh/mesh_judge.hpp"

#include "core/engine/mesh/verify.hpp"
#include "ui/style/measure_colours.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <utility>

namespace forefront {

namespace {

bool needsEdges(const JudgeRequest &request) {
    return request.parts || request.limits.any() || request.measure == Measure::AreaRatio ||
           infoOf(request.measure).part == MeshPart::Edges;
}

BoxTree treeOf(const TriMesh &mesh) {
    std::vector<Box2> boxes(mesh.elements.size());
    for (std::size_t e = 0; e < boxes.size(); ++e) {
        for (const NodeId node : mesh.elements[e]) {
            boxes[e].add(mesh.nodes[index(node)]);
        }
    }
    return BoxTree(boxes);
}

std::shared_ptr<const std::vector<MeshEdge>> singleEdges(const MeshEdges &edges) {
    auto outline = std::make_shared<std::vector<MeshEdge>>();
    std::copy_if(edges.edges.begin(), edges.edges.end(), std::back_inserter(*outline),
                 [](const MeshEdge &edge) { return edge.elements[1] == kNoElement; });
    return outline;
}

/// Summarises the values of a field on a linear scale from their minimum to their maximum.
void showField(Judgement &judgement) {
    constexpr std::size_t kBins = 40;
    judgement.name = judgement.of.field;
    judgement.info.part = judgement.of.fieldPart;
    judgement.info.symbol = "value";
    judgement.info.minimum = -std::numeric_limits<double>::infinity();
    judgement.values = *judgement.of.fieldValues;
    const MeasureSummary summary = summarise(judgement.values);
    judgement.summary = summary;
    const double narrowest = 1e-9 * std::max(std::abs(summary.minimum), std::abs(summary.maximum));
    const double to = std::max(
        summary.maximum, std::min(summary.minimum + std::max(narrowest, 1e-300), std::numeric_limits<double>::max()));
    judgement.fitted = {summary.minimum, to};
    judgement.histogram = histogramOf(judgement.values, summary.minimum, to, false, kBins);
}

/// Evaluates the expression of a request. One that has no values on this mesh leaves the colours of α.
void addFormula(JudgeRequest &of, const Judgement &earlier) {
    const bool same = earlier.of.mesh == of.mesh && earlier.of.formula == of.formula;
    if (same && earlier.of.fieldValues) {
        of.fieldValues = earlier.of.fieldValues;
    } else if (Result<std::vector<double>> values = coloursOn(of.formula, of.mesh->mesh, {})) {
        of.fieldValues = std::make_shared<const std::vector<double>>(*std::move(values));
    } else {
        of.measure = Measure::ShapeFactor;
        of.field.clear();
    }
}

/// Measures the values; `judgement` has its edges.
void measureInto(Judgement &judgement) {
    static const MeshEdges kNoEdges;
    const JudgeRequest &of = judgement.of;
    const MeshEdges &edges = judgement.edges ? *judgement.edges : kNoEdges;
    judgement.name = infoOf(of.measure).name;
    judgement.info = infoOf(of.measure);
    if (of.fieldValues) {
        showField(judgement);
        return;
    }
    judgement.values = measureValues(of.measure, of.mesh->view(), edges, of.spacing.get());
    judgement.summary = summarise(judgement.values);
    judgement.histogram = shownHistogram(of.measure, judgement.values, judgement.summary);
    judgement.fitted = fittedRange(of.measure, judgement.summary);
    judgement.worst = worstParts(of.measure, judgement.values, Judgement::kRanked);
}

} // namespace

std::shared_ptr<const Judgement> judgementOf(const JudgeRequest &request, const Judgement &earlier) {
    auto judgement = std::make_shared<Judgement>();
    judgement->of = request;
    if (!request.mesh) {
        return judgement;
    }
    if (request.formula.any()) {
        addFormula(judgement->of, earlier);
    }
    const MeshView mesh = request.mesh->view();
    const bool same = earlier.of.mesh == request.mesh;
    const bool sameSpacing = same && earlier.of.spacing == request.spacing;
    if (needsEdges(request)) {
        judgement->edges = same && earlier.edges ? earlier.edges : std::make_shared<const MeshEdges>(edgesOf(mesh));
    }
    if (request.parts) {
        judgement->tree =
            same && earlier.tree ? earlier.tree : std::make_shared<const BoxTree>(treeOf(request.mesh->mesh));
    }
    if (request.outline && judgement->edges) {
        judgement->outline = same && earlier.outline ? earlier.outline : singleEdges(*judgement->edges);
    }
    if (request.verify) {
        judgement->faults = same && earlier.of.verify ? earlier.faults : verify(mesh);
    }
    if (request.quality) {
        judgement->quality =
            sameSpacing && earlier.quality ? earlier.quality : measureQuality(mesh, request.spacing.get());
    }
    if (request.limits.any()) {
        judgement->verdicts = sameSpacing && earlier.of.limits == request.limits
                                  ? earlier.verdicts
                                  : checkLimits(mesh, *judgement->edges, request.limits, request.spacing.get());
    }
    measureInto(*judgement);
    return judgement;
}

Vec2 placeOf(const Judgement &judgement, MeshPart part, std::uint32_t index) {
    static const MeshEdges kNoEdges;
    return placeOf(judgement.of.mesh->view(), judgement.edges ? *judgement.edges : kNoEdges, part, index);
}

namespace {

using JudgeTurn = LatestTurn<JudgeRequest, std::shared_ptr<const Judgement>>;

/// Returns the evaluation, or one with an out-of-memory fault.
std::shared_ptr<const Judgement> judgementWithin(const JudgeTurn &turn, const MeshJudge::Answer &answer) {
    try {
        return answer(turn.request, *turn.earlier);
    } catch (const std::bad_alloc &) {
        auto judgement = std::make_shared<Judgement>();
        judgement->of = turn.request;
        judgement->faults = error("out-of-memory", "not enough memory to evaluate the mesh",
                                  "close other programs, or open a smaller mesh");
        return judgement;
    }
}

} // namespace

MeshJudge::MeshJudge(BackgroundList &list, Answer answer)
    : worker_(
          list, [answer = std::move(answer)](const JudgeTurn &turn) { return judgementWithin(turn, answer); },
          std::make_shared<const Judgement>()) {}

void MeshJudge::submit(const JudgeRequest &request) {
    if (!(wanted_ == request)) {
        wanted_ = request;
        worker_.submit(request);
    }
}

} // namespace forefront
