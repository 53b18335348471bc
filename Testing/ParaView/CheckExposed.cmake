# SPDX-FileCopyrightText: VolumeOptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Every setting of the mapper and of its property is one of the representation's panel, but for those named here.
#   cmake -DSOURCE_FOLDER=... -P CheckExposed.cmake

# Which are for programs; what ParaView connects or sets itself; and what has other names in the panel.
set(exceptions
  AnisotropyInputConnection AnisotropyInputData DefaultOptics DrawnExtent GlobalOverride LineBlockInputConnection
  LineBlockInputData LineOpacityFunction NormalsInputConnection NormalsInputData Optics SampleDistance WholeExtent
  AnisotropyScale Glossiness LightingTransferFunction MultiSampleClassification ScatteringAnisotropy)

cmake_policy(SET CMP0057 NEW)
set(names)
foreach (header IN ITEMS vtkOpticsVolumeMapper.h vtkOpticsVolumeProperty.h)
  file(READ "${SOURCE_FOLDER}/Rendering/${header}" text)
  string(REGEX MATCHALL "(void Set|vtkSet[A-Za-z0-9]*Macro\\()[A-Z][A-Za-z0-9]*" found "${text}")
  list(TRANSFORM found REPLACE "^(void Set|vtkSet[A-Za-z0-9]*Macro.)" "")
  list(APPEND names ${found})
endforeach ()
list(FILTER names EXCLUDE REGEX "To[A-Z]")
list(REMOVE_DUPLICATES names)
list(LENGTH names count)
if (count LESS 50)
  message(FATAL_ERROR "only ${count} settings found in the headers")
endif ()

file(READ "${SOURCE_FOLDER}/Module/ParaView/VolumeRepresentation.xml" panel)
set(missing)
foreach (name IN LISTS names)
  if (NOT name IN_LIST exceptions AND NOT panel MATCHES "command=\"Set${name}\"")
    list(APPEND missing "${name}")
  endif ()
endforeach ()
if (missing)
  message(FATAL_ERROR "not in VolumeRepresentation.xml: ${missing}")
endif ()

# What is declared is in a group of the panel.
string(REGEX MATCHALL "Property name=\"[A-Za-z]+\" command=" declared "${panel}")
foreach (property IN LISTS declared)
  string(REGEX REPLACE "^Property name=\"([A-Za-z]+)\".*" "\\1" name "${property}")
  if (NOT panel MATCHES "<Property name=\"${name}\"")
    message(FATAL_ERROR "${name} is in no group of the panel")
  endif ()
endforeach ()
