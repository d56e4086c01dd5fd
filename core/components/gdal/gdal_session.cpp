#include "core/components/gdal/gdal_session.hpp"

#include <atomic>
#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <mutex>

namespace forefront::gdal {

Session::Session(GdalReport &report) : report_(report) {
    static std::once_flag registered;
    std::call_once(registered, GDALAllRegister);
    CPLPushErrorHandlerEx(collect, this);
}

Session::~Session() {
    if (!memoryFile_.empty()) {
        VSIUnlink(memoryFile_.c_str());
    }
    CPLPopErrorHandler();
}

void CPL_STDCALL Session::collect(CPLErr kind, CPLErrorNum, const char *text) {
    Session &session = *static_cast<Session *>(CPLGetErrorHandlerUserData());
    constexpr std::size_t kMost = 20;
    if (kind == CE_Failure || kind == CE_Fatal) {
        session.lastError_ = text;
    } else if (kind == CE_Warning && session.report_.warnings.size() < kMost) {
        session.report_.warnings.emplace_back(text);
    }
}

bool Session::fail(const std::string &what, const std::string &advice) {
    report_.message = lastError_.empty() ? what : what + ": " + lastError_;
    report_.advice = advice;
    return false;
}

Dataset Session::open(const GdalFile &file, unsigned flags) {
    std::string path = file.path;
    if (path.empty()) {
        static std::atomic<unsigned> number{0};
        memoryFile_ = "/vsimem/forefront-" + std::to_string(number++);
        path = memoryFile_;
        // GDAL only reads them, and does not take them over.
        auto *const bytes = reinterpret_cast<GByte *>(const_cast<char *>(file.bytes->data()));
        VSILFILE *const opened = VSIFileFromMemBuffer(path.c_str(), bytes, file.bytes->size(), FALSE);
        if (opened == nullptr) {
            fail("cannot read the file in memory");
            return {};
        }
        VSIFCloseL(opened);
    }
    std::vector<const char *> drivers = file.drivers;
    drivers.push_back(nullptr);
    Dataset set(GDALOpenEx(path.c_str(), flags | GDAL_OF_READONLY, drivers.data(), nullptr, nullptr));
    if (set == nullptr) {
        fail("GDAL cannot read the file");
    }
    return set;
}

ReferenceSystem Session::named(const std::string &name) {
    ReferenceSystem system(OSRNewSpatialReference(nullptr));
    if (OSRSetFromUserInput(system.get(), name.c_str()) != OGRERR_NONE) {
        fail("unknown coordinate reference system '" + name + "'", "expected a code such as EPSG:3067");
        return {};
    }
    if (OSRIsProjected(system.get()) == 0 && OSRIsGeographic(system.get()) == 0 && OSRIsLocal(system.get()) == 0) {
        fail("the coordinate reference system '" + name + "' is not for maps",
             "expected one with longitudes and latitudes or with coordinates in a plane");
        return {};
    }
    OSRSetAxisMappingStrategy(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
    return system;
}

} // namespace forefront::gdal
