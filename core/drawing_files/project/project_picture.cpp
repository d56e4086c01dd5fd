#include "core/drawing_files/project/project_picture.hpp"

namespace forefront {
namespace {

std::filesystem::path folderOf(const std::filesystem::path &project) {
    std::error_code ignored;
    return std::filesystem::absolute(project, ignored).lexically_normal().parent_path();
}

std::string relativeTo(const std::filesystem::path &project, const std::string &file) {
    const std::filesystem::path path = file;
    if (project.empty() || path.is_relative()) {
        return file;
    }
    const std::filesystem::path relative = path.lexically_normal().lexically_relative(folderOf(project));
    return relative.empty() ? file : relative.generic_string();
}

} // namespace

void writePicture(const BackgroundPicture &picture, const std::filesystem::path &project, JsonText &out) {
    out << ",\n  \"picture\": {\"file\": " << jsonString(relativeTo(project, picture.file)) << ", \"at\": ";
    out.point(picture.corner);
    out << ", \"size\": ";
    out.point(picture.size);
    if (picture.angle != 0.0) {
        out << ", \"angle\": ";
        out.number(picture.angle);
    }
    out << ", \"opacity\": ";
    out.number(picture.opacity);
    out << (picture.locked ? ", \"locked\": true}" : "}");
}

BackgroundPicture readPicture(const JsonValue &object, const std::filesystem::path &project, JsonCheck &check) {
    BackgroundPicture picture;
    if (const auto file = check.member(object, "file", "the picture")) {
        picture.file = check.string(*file, "the file of the picture");
        if (picture.file.empty()) {
            check.fault(*file, "bad-field", "expected the path of the picture, got \"\"");
        } else if (!project.empty() && std::filesystem::path(picture.file).is_relative()) {
            picture.file = (folderOf(project) / picture.file).lexically_normal().string();
        }
    }
    if (const auto at = check.member(object, "at", "the picture")) {
        picture.corner = check.point(*at, "the corner of the picture");
    }
    if (const auto size = check.member(object, "size", "the picture")) {
        picture.size = check.point(*size, "the size of the picture");
        if (!(picture.size.x > 0.0 && picture.size.y > 0.0)) {
            check.fault(*size, "bad-number", "the width and height of the picture must be above 0");
        }
    }
    if (const auto opacity = object.find("opacity")) {
        picture.opacity = check.number(*opacity, "\"opacity\"");
        if (!(picture.opacity >= 0.0 && picture.opacity <= 1.0)) {
            check.fault(*opacity, "bad-number", "\"opacity\" must lie between 0 and 1");
        }
    }
    if (const auto angle = object.find("angle")) {
        picture.angle = check.number(*angle, "\"angle\"");
    }
    if (const auto locked = object.find("locked")) {
        picture.locked = check.flag(*locked, "\"locked\"");
    }
    return picture;
}

} // namespace forefront
