#include "core/drawing_files/project/project_water.hpp"

#include "core/drawing_files/project/project_tags.hpp"
#include "core/files/json/json.hpp"

namespace forefront {

void writeWater(const Document &document, JsonText &out) {
    writeTags("openBoundaries", document.openBoundaries, out);
    if (!document.elevation.empty()) {
        out << ",\n  \"elevation\": " << jsonString(document.elevation);
    }
}

void readWater(const JsonValue &root, Document &document, JsonCheck &check) {
    if (const auto elevation = root.find("elevation")) {
        document.elevation = check.string(*elevation, "\"elevation\"");
    }
    readTags(root, "openBoundaries", "is open twice", document.openBoundaries, check);
}

} // namespace forefront
