#include "core/files/format_list.hpp"

#include "core/engine/base/letter_case.hpp"
#include "core/files/format.hpp"
#include "core/files/json/json_outline.hpp"
#include "core/files/source/source.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace forefront {
namespace {

std::string lowerExtension(const std::filesystem::path &path) {
    return lowerCase(path.extension().string());
}

bool hasExtension(const Format &format, const std::string &extension) {
    if (extension == format.about.extension) {
        return true;
    }
    const std::string others = std::string(" ") + format.about.otherExtensions + ' ';
    return extension.size() > 1 && others.find(' ' + extension + ' ') != std::string::npos;
}

} // namespace

std::vector<FileFormat> FormatList::list() const {
    std::vector<FileFormat> list;
    for (const Format &format : formats_) {
        list.push_back(format.about);
    }
    return list;
}

const FileFormat *FormatList::withId(std::string_view id) const {
    const Format *const format = ofId(id);
    return format == nullptr ? nullptr : &format->about;
}

const FileFormat *FormatList::detect(const std::filesystem::path &path) const {
    if (!notRegular(path).empty()) {
        return detect(path, {}); // a pipe can be read only once, and could wait for ever
    }
    std::string head(kHeadBytes, '\0');
    std::ifstream stream(path, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
    if (stream.good() && beginsAsObject(head) && recognised(path, head) == nullptr) {
        if (const Result<std::string> all = readFileBytes(path, ImportOptions().maxBytes)) {
            return detect(path, *all);
        }
    }
    return detect(path, head);
}

const FileFormat *FormatList::detect(const std::filesystem::path &path, std::string_view content) const {
    const Format *const format = ofContent(path, content);
    return format == nullptr ? nullptr : &format->about;
}

std::string FormatList::extensions(bool (*accepts)(const Format &)) const {
    std::string list;
    for (const Format &format : formats_) {
        if (accepts(format) && list.find(format.about.extension) == std::string::npos) {
            list += (list.empty() ? "" : " ") + std::string(format.about.extension);
        }
    }
    return list;
}

std::vector<std::string> FormatList::allExtensions(bool (*accepts)(const FileFormat &)) const {
    std::vector<std::string> all;
    for (const Format &format : formats_) {
        std::istringstream words(accepts(format.about)
                                     ? std::string(format.about.extension) + ' ' + format.about.otherExtensions
                                     : std::string());
        for (std::string word; words >> word;) {
            if (std::find(all.begin(), all.end(), word) == all.end()) {
                all.push_back(word);
            }
        }
    }
    return all;
}

std::string FormatList::ids(bool (*accepts)(const Format &)) const {
    std::string list;
    for (const Format &format : formats_) {
        if (accepts(format)) {
            list += (list.empty() ? "" : ", ") + std::string(format.about.id);
        }
    }
    return list;
}

std::vector<const FileFormat *> FormatList::withExtensionOf(const std::filesystem::path &path) const {
    const std::string extension = lowerExtension(path);
    std::vector<const FileFormat *> named;
    for (const Format &format : formats_) {
        if (hasExtension(format, extension)) {
            named.push_back(&format.about);
        }
    }
    return named;
}

const Format *FormatList::recognised(const std::filesystem::path &path, std::string_view head) const {
    const std::string extension = lowerExtension(path);
    const Format *found = nullptr;
    for (const Format &format : formats_) {
        if (format.recognise != nullptr && format.recognise(head)) {
            if (hasExtension(format, extension)) {
                return &format;
            }
            found = found == nullptr ? &format : found;
        }
    }
    return found;
}

const Format *FormatList::ofContent(const std::filesystem::path &path, std::string_view content) const {
    const std::string_view head = content.substr(0, kHeadBytes);
    if (const Format *const found = recognised(path, head)) {
        return found;
    }
    if (content.size() > head.size() && beginsAsObject(head)) {
        for (const Format &format : formats_) {
            if (format.mayShowLate && format.recognise(content)) {
                return &format;
            }
        }
    }
    return ofExtension(path, [](const Format &) { return true; });
}

const Format *FormatList::ofExtension(const std::filesystem::path &path, bool (*accepts)(const Format &)) const {
    const std::string extension = lowerExtension(path);
    const auto found = std::find_if(formats_.begin(), formats_.end(),
                                    [&](const Format &f) { return hasExtension(f, extension) && accepts(f); });
    return found != formats_.end() ? &*found : nullptr;
}

const Format *FormatList::ofId(std::string_view id) const {
    const auto found =
        std::find_if(formats_.begin(), formats_.end(), [&](const Format &f) { return id == f.about.id; });
    return found != formats_.end() ? &*found : nullptr;
}

} // namespace forefront
