// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PluginVersions.h"

#include "vtkPVPluginsInformation.h"
#include "vtkSMPluginManager.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkWeakPointer.h"

namespace
{
const char* const PluginName = "VolumeOptics";

std::string VersionIn(vtkPVPluginsInformation* plugins)
{
  const unsigned int count = plugins ? plugins->GetNumberOfPlugins() : 0;
  for (unsigned int i = 0; i < count; ++i)
  {
    if (plugins->GetPluginLoaded(i) && std::string(PluginName) == plugins->GetPluginName(i))
    {
      return plugins->GetPluginVersion(i);
    }
  }
  return std::string();
}
}

//------------------------------------------------------------------------------
std::string FindOtherVersion()
{
  static vtkWeakPointer<vtkSMSession> asked;
  vtkSMProxyManager* proxies =
    vtkSMProxyManager::IsInitialized() ? vtkSMProxyManager::GetProxyManager() : nullptr;
  vtkSMSession* session = proxies ? proxies->GetActiveSession() : nullptr;
  if (!session || session == asked)
  {
    return std::string();
  }
  const std::string ours = VersionIn(proxies->GetPluginManager()->GetLocalInformation());
  const std::string theirs = VersionIn(proxies->GetPluginManager()->GetRemoteInformation(session));
  if (ours.empty() || theirs.empty())
  {
    return std::string();
  }
  asked = session;
  return ours == theirs ? std::string()
                        : std::string("The plugin ") + PluginName + " is of version " + ours +
      " on the client and " + theirs + " on the server: load the same version on both.";
}
