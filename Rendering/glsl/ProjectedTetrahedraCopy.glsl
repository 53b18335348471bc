// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::System::Dec
//VTK::Output::Dec

// The finished picture, associated colour, over what the framebuffer holds.

in vec2 texCoord;
uniform sampler2D in_picture;

void main()
{
  gl_FragData[0] = texture(in_picture, texCoord);
}
