// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpticsFactory.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkVersion.h"

#include <string>

// VTK 9.2 made some functions const, and later ones have the name of it.
#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkHeadlessRenderWindow);
VTK_CREATE_CREATE_FUNCTION(vtkGenericRenderWindowInteractor);
VTK_CREATE_CREATE_FUNCTION(vtkOpticsVolumeMapper);

class Factory : public vtkObjectFactory
{
public:
  static Factory* New();
  vtkTypeMacro(Factory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "VolumeOptics"; }

protected:
  Factory()
  {
    this->Add("vtkRenderWindow", "vtkHeadlessRenderWindow", vtkObjectFactoryCreatevtkHeadlessRenderWindow);
    this->Add("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      vtkObjectFactoryCreatevtkGenericRenderWindowInteractor);
    this->Add(
      "vtkGPUVolumeRayCastMapper", "vtkOpticsVolumeMapper", vtkObjectFactoryCreatevtkOpticsVolumeMapper);
  }

private:
  void Add(const char* overridden, const char* with, CreateFunction create)
  {
    this->RegisterOverride(overridden, with, "VolumeOptics", 0, create);
  }
};
vtkStandardNewMacro(Factory);

//------------------------------------------------------------------------------
Factory* FindFactory()
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator iterator;
  factories->InitTraversal(iterator);
  while (vtkObjectFactory* factory = factories->GetNextObjectFactory(iterator))
  {
    if (auto* found = dynamic_cast<Factory*>(factory))
    {
      return found;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
Factory* FindOrRegisterFactory()
{
  if (Factory* found = FindFactory())
  {
    return found;
  }
  vtkNew<Factory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  factories->RemoveItem(factory);
  const int front = -1;
  factories->InsertItem(front, factory);
  return factory;
}
}

//------------------------------------------------------------------------------
void OpticsFactory::SetEnabled(const char* className, bool enabled)
{
  FindOrRegisterFactory()->SetEnableFlag(enabled, className, nullptr);
}

//------------------------------------------------------------------------------
bool OpticsFactory::GetEnabled(const char* className)
{
  Factory* factory = FindFactory();
  for (int i = 0; factory && i < factory->GetNumberOfOverrides(); ++i)
  {
    if (std::string(factory->GetClassOverrideName(i)) == className)
    {
      return factory->GetEnableFlag(i) != 0;
    }
  }
  return false;
}
