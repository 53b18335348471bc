// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec
//VTK::Output::Dec

// Fragment shader of the atlas of evaluated voxels.

flat in vec4 evaluated;

void main()
{
  gl_FragData[0] = evaluated;
}
