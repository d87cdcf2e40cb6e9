#pragma once
// A new folder for what is needed for a while.
#include <filesystem>

namespace morula {

/// Made with a name that nothing else has, and removed with all that it then holds, so that no file of the
/// user's can be in it. Throws FileError.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::filesystem::path& parent);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace morula
