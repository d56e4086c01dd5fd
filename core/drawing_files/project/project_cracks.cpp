#include "core/drawing_files/project/project_cracks.hpp"

#include "core/drawing_files/project/project_tags.hpp"

namespace forefront {

void writeCracks(const Document &document, JsonText &out) {
    writeTags("cracks", document.cracks, out);
}

void readCracks(const JsonValue &root, Document &document, JsonCheck &check) {
    readTags(root, "cracks", "is a crack twice", document.cracks, check);
}

} // namespace forefront
