#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "imaging/ct_import.h"
#include "imaging/surfaces.h"
#include "phantom/head_phantom.h"
#include "support/head_ct.h"
#include "support/temporary_folder.h"

namespace gnathion::test {

/// The bone of the analytic head, made once for this process.
inline const TriangleMesh& analytic_bone() {
  static const TriangleMesh bone = [] {
    const TemporaryFolder folder;
    Progress progress;
    write_phantom_case(folder.path(), {}, progress);
    return bone_surface(read_ct(folder.path() / "ct", std::nullopt, progress), {}, progress);
  }();
  return bone;
}

/// The bone of the real CT, likewise; without triangles when the shared data are not there.
inline const TriangleMesh& real_bone() {
  static const TriangleMesh bone = [] {
    const auto folder = head_ct_folder();
    if (folder.empty()) return TriangleMesh{Points(0, 3), Triangles(0, 3)};
    Progress progress;
    return bone_surface(read_ct(folder, std::nullopt, progress), {}, progress);
  }();
  return bone;
}

}  // namespace gnathion::test
