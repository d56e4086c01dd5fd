#include "ui/workspace/compared_mesh.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

std::shared_ptr<const MeshView> viewOf(Mesh mesh, std::uint64_t version) {
    auto view = std::make_shared<MeshView>();
    view->alpha = shapeFactors(mesh);
    view->mesh = std::move(mesh);
    view->version = version;
    return view;
}

} // namespace

ComparedMesh::ComparedMesh(std::string name, MeshFields read, std::uint64_t version, std::function<void()> wake)
    : name_(std::move(name)), fields_(takeFields(read)), view_(viewOf(std::move(read.mesh), version)),
      judge_(std::move(wake)), judgement_(judge_.latest()) {}

bool ComparedMesh::follow(JudgeRequest request) {
    request.mesh = view_;
    // The values of the canvas belong to its mesh. If the file has no such field, nothing is shown.
    if (request.fieldValues) {
        const std::vector<double> *const values = fields_ ? fields_->find(request.fieldPart, request.field) : nullptr;
        request.fieldValues = values ? std::shared_ptr<const std::vector<double>>(fields_, values) : nullptr;
        if (!values) {
            request.field.clear();
        }
    }
    request.limits = {};
    request.verify = false;
    request.parts = true;
    request.quality = true;
    judge_.submit(request);
    std::shared_ptr<const Judgement> newest = judge_.latest();
    if (newest == judgement_) {
        return false;
    }
    if (newest->edges && newest->edges != judgement_->edges) {
        outline_.clear();
        std::copy_if(newest->edges->edges.begin(), newest->edges->edges.end(), std::back_inserter(outline_),
                     [](const MeshEdge &edge) { return edge.elements[1] == kNoElement; });
    }
    judgement_ = std::move(newest);
    return true;
}

std::optional<MeshFigures> figuresOf(const Judgement &judgement) {
    if (!judgement.quality) {
        return std::nullopt;
    }
    return MeshFigures{*judgement.quality, judgement.of.spacing != nullptr, std::nullopt};
}

} // namespace forefront
