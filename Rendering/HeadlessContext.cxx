// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeadlessContext.h"

#include <cstdlib>

//------------------------------------------------------------------------------
std::unique_ptr<HeadlessContext> HeadlessContext::Create(std::string& reason)
{
  const char* variable = std::getenv("VOLUMEOPTICS_HEADLESS");
  const std::string wanted = variable ? variable : "";
  if (wanted == "egl")
  {
    return CreateEGLContext(reason);
  }
  if (wanted == "osmesa")
  {
    return CreateOSMesaContext(reason);
  }
  std::string reasonOfEGL;
  auto context = CreateEGLContext(reasonOfEGL);
  if (!context)
  {
    std::string reasonOfOSMesa;
    context = CreateOSMesaContext(reasonOfOSMesa);
    reason = reasonOfEGL + " " + reasonOfOSMesa;
  }
  return context;
}
