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

# What is declared is in a group of the panel, and has a condition to be shown, but for what has an effect with every
# setting, and for lines, which the panel does not know.
set(always
  Classification IntegrationSpace LineOpacityScale LinePrecision LineRadiusScale MultiSampleFile Occlusion OpticsQuality
  SkipEmptySpace)
string(REPLACE ";" "," declared "${panel}")
string(FIND "${declared}" "<Extension" end)
string(SUBSTRING "${declared}" 0 ${end} declared)
string(REGEX REPLACE "<[A-Za-z]*Property name=\"([A-Za-z]+)\" command=" ";\\1 " declared "${declared}")
list(REMOVE_AT declared 0)
foreach (property IN LISTS declared)
  string(REGEX MATCH "^[A-Za-z]+" name "${property}")
  if (NOT panel MATCHES "<Property name=\"${name}\"")
    message(SEND_ERROR "${name} is in no group of the panel")
  endif ()
  if (NOT name IN_LIST always AND NOT property MATCHES "mode=\"visibility\"")
    message(SEND_ERROR "${name} is shown where it has no effect")
  endif ()
endforeach ()
