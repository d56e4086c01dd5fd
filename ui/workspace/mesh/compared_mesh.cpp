#include "ui/workspace/mesh/compared_mesh.hpp"

#include <utility>

namespace forefront {

ComparedFile comparedFile(MeshFields read) {
    ComparedFile file;
    file.view = std::make_shared<MeshSnapshot>();
    file.view->mesh = takeTriangles(read);
    file.view->alpha = shapeFactors(file.view->mesh);
    file.fields = takeFields(read, file.view->mesh);
    return file;
}

ComparedMesh::ComparedMesh(std::string name, ComparedFile file, std::uint64_t version, std::function<void()> wake)
    : name_(std::move(name)), fields_(std::move(file.fields)), judge_(std::move(wake)), judgement_(judge_.latest()) {
    file.view->version = version;
    view_ = std::move(file.view);
}

const std::vector<MeshEdge> &ComparedMesh::outline() const {
    static const std::vector<MeshEdge> kNone;
    return judgement_->outline ? *judgement_->outline : kNone;
}

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
    request.outline = true;
    request.quality = true;
    judge_.submit(request);
    std::shared_ptr<const Judgement> newest = judge_.latest();
    if (newest == judgement_) {
        return false;
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
