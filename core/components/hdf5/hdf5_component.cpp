#include "core/files/components/hdf5_component.hpp"

#include <cstring>
#include <hdf5.h>
#include <mutex>
#include <utility>

// The component that reads and writes HDF5 files, by the C interface of HDF5 1.10.

namespace {

using forefront::Hdf5Array;
using forefront::Hdf5Functions;
using forefront::Hdf5Number;
using forefront::Hdf5Values;

/// A handle of HDF5 that is closed at the end of its scope.
class Handle {
  public:
    Handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
    Handle(const Handle &) = delete;
    Handle &operator=(const Handle &) = delete;
    ~Handle() { close(); }

    bool ok() const { return id_ >= 0; }
    hid_t id() const { return id_; }
    /// Closes it; returns false on failure, such as a full disc.
    bool close() {
        const hid_t id = std::exchange(id_, -1);
        return id < 0 || close_(id) >= 0;
    }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

herr_t describe(unsigned, const H5E_error2_t *entry, void *text) {
    std::string &message = *static_cast<std::string *>(text);
    if (entry->desc != nullptr && message.empty()) {
        message = entry->desc;
    }
    return 0;
}

/// Returns false with a message: `what`, and the innermost reason that HDF5 gives.
bool fail(std::string &message, const std::string &what) {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, describe, &reason);
    message = reason.empty() ? what : what + ": " + reason;
    return false;
}

/// The library is not safe for several threads unless built for it, and prints errors by itself unless told not to.
class Session {
  public:
    Session() : lock_(mutex()) {
        H5open();
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        H5Eclear2(H5E_DEFAULT);
        H5PLset_loading_state(0); // files must not choose libraries that are loaded
    }

  private:
    static std::mutex &mutex() {
        static std::mutex only;
        return only;
    }
    std::scoped_lock<std::mutex> lock_;
};

hid_t memoryType(Hdf5Number type) {
    return type == Hdf5Number::Int32   ? H5T_NATIVE_INT32
           : type == Hdf5Number::Int64 ? H5T_NATIVE_INT64
                                       : H5T_NATIVE_DOUBLE;
}

hid_t fileType(Hdf5Number type) {
    return type == Hdf5Number::Int32 ? H5T_STD_I32LE : type == Hdf5Number::Int64 ? H5T_STD_I64LE : H5T_IEEE_F64LE;
}

bool writeArray(hid_t file, const Hdf5Array &array, std::string &message) {
    const std::vector<hsize_t> dimensions(array.dimensions.begin(), array.dimensions.end());
    const Handle space(H5Screate_simple(static_cast<int>(dimensions.size()), dimensions.data(), nullptr), H5Sclose);
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (!space.ok() || !links.ok() || !creation.ok() || H5Pset_create_intermediate_group(links.id(), 1) < 0 ||
        H5Pset_obj_track_times(creation.id(), false) < 0) {
        return fail(message, "cannot describe the array " + array.path);
    }
    const Handle set(
        H5Dcreate2(file, array.path.c_str(), fileType(array.type), space.id(), links.id(), creation.id(), H5P_DEFAULT),
        H5Dclose);
    if (!set.ok() || H5Dwrite(set.id(), memoryType(array.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values) < 0) {
        return fail(message, "cannot write the array " + array.path);
    }
    return true;
}

bool write(const std::vector<Hdf5Array> &arrays, std::string &bytes, std::string &message) {
    const Session session;
    constexpr std::size_t kIncrement = std::size_t{1} << 20;
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    if (!access.ok() || H5Pset_fapl_core(access.id(), kIncrement, false) < 0) {
        return fail(message, "cannot make a file in memory");
    }
    Handle file(H5Fcreate("forefront.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
    if (!file.ok()) {
        return fail(message, "cannot make a file in memory");
    }
    for (const Hdf5Array &array : arrays) {
        if (!writeArray(file.id(), array, message)) {
            return false;
        }
    }
    const ssize_t size = H5Fflush(file.id(), H5F_SCOPE_GLOBAL) < 0 ? -1 : H5Fget_file_image(file.id(), nullptr, 0);
    if (size < 0) {
        return fail(message, "cannot complete the file in memory");
    }
    bytes.resize(static_cast<std::size_t>(size));
    return H5Fget_file_image(file.id(), bytes.data(), bytes.size()) == size ||
           fail(message, "cannot complete the file in memory");
}

/// Reads the dimensions of an array of numbers; refuses too many.
bool readDimensions(hid_t space, std::uint64_t maximum, Hdf5Values &values, std::string &message) {
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || rank > H5S_MAX_RANK) {
        return fail(message, "the array has no dimensions");
    }
    std::vector<hsize_t> dimensions(static_cast<std::size_t>(rank));
    if (rank > 0 && H5Sget_simple_extent_dims(space, dimensions.data(), nullptr) < 0) {
        return fail(message, "the array has no dimensions");
    }
    std::uint64_t count = 1;
    for (const hsize_t dimension : dimensions) {
        if (dimension != 0 && count > maximum / dimension) {
            message = "the array has more than " + std::to_string(maximum) + " numbers";
            return false;
        }
        count *= dimension;
    }
    values.dimensions.assign(dimensions.begin(), dimensions.end());
    values.values.resize(count);
    return true;
}

bool read(const std::string &name, const std::string &path, std::uint64_t maximum, Hdf5Values &values,
          std::string &message) {
    const Session session;
    const Handle file(H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file.ok()) {
        return fail(message, "cannot open it as HDF5");
    }
    const Handle set(H5Dopen2(file.id(), path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!set.ok()) {
        return fail(message, "no array " + path);
    }
    const Handle type(H5Dget_type(set.id()), H5Tclose);
    const Handle space(H5Dget_space(set.id()), H5Sclose);
    if (!type.ok() || !space.ok()) {
        return fail(message, "cannot read the array " + path);
    }
    const H5T_class_t kind = H5Tget_class(type.id());
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
        message = "the array " + path + " holds no numbers";
        return false;
    }
    if (!readDimensions(space.id(), maximum, values, message)) {
        message = path + ": " + message;
        return false;
    }
    return values.values.empty() ||
           H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.values.data()) >= 0 ||
           fail(message, "cannot read the array " + path);
}

constexpr Hdf5Functions kFunctions = {write, read};

} // namespace

extern "C" __attribute__((visibility("default"))) const void *forefront_hdf5(const char *version) {
    return std::strcmp(version, FOREFRONT_VERSION) == 0 ? &kFunctions : nullptr;
}
