#include "ui/workspace/mesh/compared_mesh.hpp"

#include <utility>

namespace forefront {

ComparedFile comparedFile(MeshFields read) {
    ComparedFile file;
    file.fields = takeFields(read);
    file.view = snapshotOf(std::move(read.mesh));
    return file;
}

ComparedMesh::ComparedMesh(BackgroundList &list, std::string name, ComparedFile file, std::uint64_t version)
    : name_(std::move(name)), fields_(std::move(file.fields)), judge_(list) {
    file.view->version = version;
    view_ = std::move(file.view);
}

const std::vector<MeshEdge> &ComparedMesh::outline() const {
    static const std::vector<MeshEdge> kNone;
    return judgement()->outline ? *judgement()->outline : kNone;
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
    return judge_.refresh();
}

std::optional<MeshFigures> figuresOf(const Judgement &judgement) {
    if (!judgement.quality) {
        return std::nullopt;
    }
    return MeshFigures{*judgement.quality, judgement.of.spacing != nullptr, std::nullopt};
}

} // namespace forefront
