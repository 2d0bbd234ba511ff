// SPDX-License-Identifier: MIT
// The OpenGL functions that this folder calls, as one table of pointers. It is filled by the host's get_proc_address
// hook where there is one, else by libepoxy, so a host with a loader or a capture layer of its own sees every call.
// A build without libepoxy uses its headers alone, for types and constants, and needs the hook.
// A function that a newer file calls must be named in one of the lists and among the macros below:
// tests/layers/check.sh looks.
#ifndef BOLAN_GL_LOADER_H
#define BOLAN_GL_LOADER_H

#include "gl.h"

#include <epoxy/gl.h>
#include <stdbool.h>

// clang-format off
// In every OpenGL 3.3 and OpenGL ES 3.0.
#define GL_NEEDED(X) \
    X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindBufferBase) X(BindBufferRange) X(BindFramebuffer) \
    X(BindSampler) X(BindTexture) X(BindVertexArray) X(BlendEquation) X(BlendEquationSeparate) X(BlendFunc) \
    X(BlendFuncSeparate) X(BlitFramebuffer) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(Clear) \
    X(ClearBufferuiv) \
    X(ClearColor) X(ClientWaitSync) X(ColorMask) X(CompileShader) X(CopyBufferSubData) X(CreateProgram) \
    X(CreateShader) X(CullFace) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) \
    X(DeleteSamplers) X(DeleteShader) X(DeleteSync) X(DeleteTextures) X(DeleteVertexArrays) X(DepthFunc) \
    X(DepthMask) X(Disable) X(DrawArrays) X(DrawBuffers) X(DrawElements) X(Enable) X(EnableVertexAttribArray) \
    X(FenceSync) X(Finish) X(FramebufferTexture2D) X(FramebufferTextureLayer) X(FrontFace) X(GenBuffers) \
    X(GenFramebuffers) X(GenQueries) X(GenSamplers) X(GenTextures) X(GenVertexArrays) X(GenerateMipmap) \
    X(GetActiveUniform) X(GetBooleanv) X(GetBufferParameteri64v) X(GetFloatv) \
    X(GetFramebufferAttachmentParameteriv) X(GetInteger64i_v) X(GetIntegeri_v) X(GetIntegerv) \
    X(GetProgramInfoLog) X(GetProgramiv) \
    X(GetQueryObjectuiv) X(GetQueryiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetStringi) \
    X(GetUniformBlockIndex) X(GetUniformLocation) X(IsEnabled) X(IsFramebuffer) X(IsProgram) X(IsTexture) \
    X(LineWidth) X(LinkProgram) X(DrawElementsInstanced) X(PixelStorei) X(ReadBuffer) X(ReadPixels) \
    X(SamplerParameteri) X(Scissor) X(ShaderSource) X(StencilFuncSeparate) X(StencilOpSeparate) X(TexImage2D) \
    X(TexImage3D) X(TexParameterf) X(TexParameteri) X(TexSubImage2D) X(TexSubImage3D) X(Uniform1f) X(Uniform1i) \
    X(Uniform2f) X(Uniform4f) X(Uniform4fv) X(UniformBlockBinding) X(UseProgram) \
    X(VertexAttribDivisor) X(VertexAttribPointer) X(Viewport)

// In some versions only; gl_caps tells which may be called.
#define GL_OPTIONAL(X) \
    X(BindImageTexture) X(BindTextureUnit) X(BlendEquationSeparatei) X(BlendEquationi) X(BlendFuncSeparatei) \
    X(BufferStorage) X(BufferStorageEXT) X(ClampColor) X(ClearDepth) X(ClearDepthf) X(ClipControl) \
    X(ClipControlEXT) X(ColorMaski) X(DebugMessageCallback) X(DebugMessageCallbackKHR) X(DepthRange) \
    X(DepthRangeIndexed) X(DepthRangef) X(Disablei) X(DispatchCompute) X(DispatchComputeIndirect) X(Enablei) \
    X(GetBooleani_v) X(GetDoublei_v) X(GetDoublev) X(GetFloati_v) X(GetPointerv) \
    X(GetPointervKHR) X(GetQueryObjectui64v) X(GetTexLevelParameteriv) X(GetTextureParameteriv) X(IsEnabledi) \
    X(MapBufferRange) X(MemoryBarrier) X(PauseTransformFeedback) X(PixelTransferf) X(PolygonMode) X(ProvokingVertex) \
    X(QueryCounter) X(ResumeTransformFeedback) X(ScissorIndexedv) X(TexStorage2D) X(TexStorage3D) X(TextureView) \
    X(TextureViewEXT) X(TextureViewOES) X(UnmapBuffer) X(ViewportIndexedfv)

// clang-format on
#define GL_POINTER(name) __typeof__(epoxy_gl##name) name;
typedef struct gl_functions {
    GL_NEEDED(GL_POINTER)
    GL_OPTIONAL(GL_POINTER)
} gl_functions;
#undef GL_POINTER
extern gl_functions bolan_gl_functions;

// Fills the table when the hook has changed since the last call, or at the first. Thread-safe.
// NULL, or the name of the first needed function that the hook does not know.
const char *bolan_gl_load(void);

// Calls are counted: see gl_calls in gl.h. glGetString is no question: drivers answer it without waiting for anything.
extern _Thread_local gl_calls bolan_gl_calls_made;
static inline void bolan_gl_note_call(uint32_t questions) {
    bolan_gl_calls_made.count++;
    bolan_gl_calls_made.questions += questions;
}
#define bolan_gl_called(name) (bolan_gl_note_call(0), bolan_gl_functions.name)
#define bolan_gl_asked(name) (bolan_gl_note_call(1), bolan_gl_functions.name)

// Whether the current context is OpenGL ES.
bool bolan_gl_is_es(void);
// The version of the current context: 33 for OpenGL 3.3; 0 without one.
int bolan_gl_version(void);
bool bolan_gl_has_extension(const char *name);

#undef glActiveTexture
#define glActiveTexture bolan_gl_called(ActiveTexture)
#undef glAttachShader
#define glAttachShader bolan_gl_called(AttachShader)
#undef glBindBuffer
#define glBindBuffer bolan_gl_called(BindBuffer)
#undef glBindBufferBase
#define glBindBufferBase bolan_gl_called(BindBufferBase)
#undef glBindBufferRange
#define glBindBufferRange bolan_gl_called(BindBufferRange)
#undef glBindFramebuffer
#define glBindFramebuffer bolan_gl_called(BindFramebuffer)
#undef glBindImageTexture
#define glBindImageTexture bolan_gl_called(BindImageTexture)
#undef glBindSampler
#define glBindSampler bolan_gl_called(BindSampler)
#undef glBindTexture
#define glBindTexture bolan_gl_called(BindTexture)
#undef glBindTextureUnit
#define glBindTextureUnit bolan_gl_called(BindTextureUnit)
#undef glBindVertexArray
#define glBindVertexArray bolan_gl_called(BindVertexArray)
#undef glBlendEquation
#define glBlendEquation bolan_gl_called(BlendEquation)
#undef glBlendEquationSeparate
#define glBlendEquationSeparate bolan_gl_called(BlendEquationSeparate)
#undef glBlendEquationSeparatei
#define glBlendEquationSeparatei bolan_gl_called(BlendEquationSeparatei)
#undef glBlendEquationi
#define glBlendEquationi bolan_gl_called(BlendEquationi)
#undef glBlendFunc
#define glBlendFunc bolan_gl_called(BlendFunc)
#undef glBlendFuncSeparate
#define glBlendFuncSeparate bolan_gl_called(BlendFuncSeparate)
#undef glBlendFuncSeparatei
#define glBlendFuncSeparatei bolan_gl_called(BlendFuncSeparatei)
#undef glBlitFramebuffer
#define glBlitFramebuffer bolan_gl_called(BlitFramebuffer)
#undef glBufferData
#define glBufferData bolan_gl_called(BufferData)
#undef glBufferSubData
#define glBufferSubData bolan_gl_called(BufferSubData)
#undef glCheckFramebufferStatus
#define glCheckFramebufferStatus bolan_gl_asked(CheckFramebufferStatus)
#undef glClampColor
#define glClampColor bolan_gl_called(ClampColor)
#undef glClear
#define glClear bolan_gl_called(Clear)
#undef glClearBufferuiv
#define glClearBufferuiv bolan_gl_called(ClearBufferuiv)
#undef glClearColor
#define glClearColor bolan_gl_called(ClearColor)
#undef glClearDepth
#define glClearDepth bolan_gl_called(ClearDepth)
#undef glClearDepthf
#define glClearDepthf bolan_gl_called(ClearDepthf)
#undef glClipControl
#define glClipControl bolan_gl_called(ClipControl)
#undef glClipControlEXT
#define glClipControlEXT bolan_gl_called(ClipControlEXT)
#undef glColorMask
#define glColorMask bolan_gl_called(ColorMask)
#undef glColorMaski
#define glColorMaski bolan_gl_called(ColorMaski)
#undef glCompileShader
#define glCompileShader bolan_gl_called(CompileShader)
#undef glCopyBufferSubData
#define glCopyBufferSubData bolan_gl_called(CopyBufferSubData)
#undef glCreateProgram
#define glCreateProgram bolan_gl_called(CreateProgram)
#undef glCreateShader
#define glCreateShader bolan_gl_called(CreateShader)
#undef glBufferStorage
#define glBufferStorage bolan_gl_called(BufferStorage)
#undef glBufferStorageEXT
#define glBufferStorageEXT bolan_gl_called(BufferStorageEXT)
#undef glClientWaitSync
#define glClientWaitSync bolan_gl_asked(ClientWaitSync)
#undef glDeleteSync
#define glDeleteSync bolan_gl_called(DeleteSync)
#undef glFenceSync
#define glFenceSync bolan_gl_called(FenceSync)
#undef glMapBufferRange
#define glMapBufferRange bolan_gl_called(MapBufferRange)
#undef glCullFace
#define glCullFace bolan_gl_called(CullFace)
#undef glDebugMessageCallback
#define glDebugMessageCallback bolan_gl_called(DebugMessageCallback)
#undef glDebugMessageCallbackKHR
#define glDebugMessageCallbackKHR bolan_gl_called(DebugMessageCallbackKHR)
#undef glDeleteBuffers
#define glDeleteBuffers bolan_gl_called(DeleteBuffers)
#undef glDeleteFramebuffers
#define glDeleteFramebuffers bolan_gl_called(DeleteFramebuffers)
#undef glDeleteProgram
#define glDeleteProgram bolan_gl_called(DeleteProgram)
#undef glDeleteQueries
#define glDeleteQueries bolan_gl_called(DeleteQueries)
#undef glDeleteSamplers
#define glDeleteSamplers bolan_gl_called(DeleteSamplers)
#undef glDeleteShader
#define glDeleteShader bolan_gl_called(DeleteShader)
#undef glDeleteTextures
#define glDeleteTextures bolan_gl_called(DeleteTextures)
#undef glDeleteVertexArrays
#define glDeleteVertexArrays bolan_gl_called(DeleteVertexArrays)
#undef glDepthFunc
#define glDepthFunc bolan_gl_called(DepthFunc)
#undef glDepthMask
#define glDepthMask bolan_gl_called(DepthMask)
#undef glDepthRange
#define glDepthRange bolan_gl_called(DepthRange)
#undef glDepthRangeIndexed
#define glDepthRangeIndexed bolan_gl_called(DepthRangeIndexed)
#undef glDepthRangef
#define glDepthRangef bolan_gl_called(DepthRangef)
#undef glDisable
#define glDisable bolan_gl_called(Disable)
#undef glDisablei
#define glDisablei bolan_gl_called(Disablei)
#undef glDispatchCompute
#define glDispatchCompute bolan_gl_called(DispatchCompute)
#undef glDispatchComputeIndirect
#define glDispatchComputeIndirect bolan_gl_called(DispatchComputeIndirect)
#undef glDrawArrays
#define glDrawArrays bolan_gl_called(DrawArrays)
#undef glDrawBuffers
#define glDrawBuffers bolan_gl_called(DrawBuffers)
#undef glDrawElements
#define glDrawElements bolan_gl_called(DrawElements)
#undef glDrawElementsInstanced
#define glDrawElementsInstanced bolan_gl_called(DrawElementsInstanced)
#undef glEnable
#define glEnable bolan_gl_called(Enable)
#undef glEnableVertexAttribArray
#define glEnableVertexAttribArray bolan_gl_called(EnableVertexAttribArray)
#undef glEnablei
#define glEnablei bolan_gl_called(Enablei)
#undef glFinish
#define glFinish bolan_gl_asked(Finish)
#undef glFramebufferTexture2D
#define glFramebufferTexture2D bolan_gl_called(FramebufferTexture2D)
#undef glFramebufferTextureLayer
#define glFramebufferTextureLayer bolan_gl_called(FramebufferTextureLayer)
#undef glFrontFace
#define glFrontFace bolan_gl_called(FrontFace)
#undef glGenBuffers
#define glGenBuffers bolan_gl_called(GenBuffers)
#undef glGenFramebuffers
#define glGenFramebuffers bolan_gl_called(GenFramebuffers)
#undef glGenQueries
#define glGenQueries bolan_gl_called(GenQueries)
#undef glGenSamplers
#define glGenSamplers bolan_gl_called(GenSamplers)
#undef glGenTextures
#define glGenTextures bolan_gl_called(GenTextures)
#undef glGenVertexArrays
#define glGenVertexArrays bolan_gl_called(GenVertexArrays)
#undef glGenerateMipmap
#define glGenerateMipmap bolan_gl_called(GenerateMipmap)
#undef glGetActiveUniform
#define glGetActiveUniform bolan_gl_asked(GetActiveUniform)
#undef glGetBooleanv
#define glGetBooleanv bolan_gl_asked(GetBooleanv)
#undef glGetBufferParameteri64v
#define glGetBufferParameteri64v bolan_gl_asked(GetBufferParameteri64v)
#undef glGetDoublev
#define glGetDoublev bolan_gl_asked(GetDoublev)
#undef glGetFloatv
#define glGetFloatv bolan_gl_asked(GetFloatv)
#undef glGetFramebufferAttachmentParameteriv
#define glGetFramebufferAttachmentParameteriv bolan_gl_asked(GetFramebufferAttachmentParameteriv)
#undef glGetInteger64i_v
#define glGetInteger64i_v bolan_gl_asked(GetInteger64i_v)
#undef glGetIntegeri_v
#define glGetIntegeri_v bolan_gl_asked(GetIntegeri_v)
#undef glGetBooleani_v
#define glGetBooleani_v bolan_gl_asked(GetBooleani_v)
#undef glGetDoublei_v
#define glGetDoublei_v bolan_gl_asked(GetDoublei_v)
#undef glGetFloati_v
#define glGetFloati_v bolan_gl_asked(GetFloati_v)
#undef glGetIntegerv
#define glGetIntegerv bolan_gl_asked(GetIntegerv)
#undef glGetPointerv
#define glGetPointerv bolan_gl_asked(GetPointerv)
#undef glGetPointervKHR
#define glGetPointervKHR bolan_gl_asked(GetPointervKHR)
#undef glGetProgramInfoLog
#define glGetProgramInfoLog bolan_gl_asked(GetProgramInfoLog)
#undef glGetProgramiv
#define glGetProgramiv bolan_gl_asked(GetProgramiv)
#undef glGetQueryObjectui64v
#define glGetQueryObjectui64v bolan_gl_asked(GetQueryObjectui64v)
#undef glGetQueryObjectuiv
#define glGetQueryObjectuiv bolan_gl_asked(GetQueryObjectuiv)
#undef glGetQueryiv
#define glGetQueryiv bolan_gl_asked(GetQueryiv)
#undef glGetShaderInfoLog
#define glGetShaderInfoLog bolan_gl_asked(GetShaderInfoLog)
#undef glGetShaderiv
#define glGetShaderiv bolan_gl_asked(GetShaderiv)
#undef glGetStringi
#define glGetStringi bolan_gl_called(GetStringi)
#undef glGetString
#define glGetString bolan_gl_called(GetString)
#undef glGetTexLevelParameteriv
#define glGetTexLevelParameteriv bolan_gl_asked(GetTexLevelParameteriv)
#undef glGetTextureParameteriv
#define glGetTextureParameteriv bolan_gl_asked(GetTextureParameteriv)
#undef glGetUniformBlockIndex
#define glGetUniformBlockIndex bolan_gl_asked(GetUniformBlockIndex)
#undef glGetUniformLocation
#define glGetUniformLocation bolan_gl_asked(GetUniformLocation)
#undef glIsEnabled
#define glIsEnabled bolan_gl_asked(IsEnabled)
#undef glIsEnabledi
#define glIsEnabledi bolan_gl_asked(IsEnabledi)
#undef glIsFramebuffer
#define glIsFramebuffer bolan_gl_asked(IsFramebuffer)
#undef glIsProgram
#define glIsProgram bolan_gl_asked(IsProgram)
#undef glIsTexture
#define glIsTexture bolan_gl_asked(IsTexture)
#undef glLineWidth
#define glLineWidth bolan_gl_called(LineWidth)
#undef glLinkProgram
#define glLinkProgram bolan_gl_called(LinkProgram)
#undef glMemoryBarrier
#define glMemoryBarrier bolan_gl_called(MemoryBarrier)
#undef glPauseTransformFeedback
#define glPauseTransformFeedback bolan_gl_called(PauseTransformFeedback)
#undef glPixelStorei
#define glPixelStorei bolan_gl_called(PixelStorei)
#undef glPixelTransferf
#define glPixelTransferf bolan_gl_called(PixelTransferf)
#undef glPolygonMode
#define glPolygonMode bolan_gl_called(PolygonMode)
#undef glProvokingVertex
#define glProvokingVertex bolan_gl_called(ProvokingVertex)
#undef glQueryCounter
#define glQueryCounter bolan_gl_called(QueryCounter)
#undef glReadBuffer
#define glReadBuffer bolan_gl_called(ReadBuffer)
#undef glReadPixels
#define glReadPixels bolan_gl_asked(ReadPixels)
#undef glResumeTransformFeedback
#define glResumeTransformFeedback bolan_gl_called(ResumeTransformFeedback)
#undef glSamplerParameteri
#define glSamplerParameteri bolan_gl_called(SamplerParameteri)
#undef glScissor
#define glScissor bolan_gl_called(Scissor)
#undef glScissorIndexedv
#define glScissorIndexedv bolan_gl_called(ScissorIndexedv)
#undef glShaderSource
#define glShaderSource bolan_gl_called(ShaderSource)
#undef glStencilFuncSeparate
#define glStencilFuncSeparate bolan_gl_called(StencilFuncSeparate)
#undef glStencilOpSeparate
#define glStencilOpSeparate bolan_gl_called(StencilOpSeparate)
#undef glTexImage2D
#define glTexImage2D bolan_gl_called(TexImage2D)
#undef glTexImage3D
#define glTexImage3D bolan_gl_called(TexImage3D)
#undef glTexParameterf
#define glTexParameterf bolan_gl_called(TexParameterf)
#undef glTexParameteri
#define glTexParameteri bolan_gl_called(TexParameteri)
#undef glTexStorage2D
#define glTexStorage2D bolan_gl_called(TexStorage2D)
#undef glTexStorage3D
#define glTexStorage3D bolan_gl_called(TexStorage3D)
#undef glTexSubImage2D
#define glTexSubImage2D bolan_gl_called(TexSubImage2D)
#undef glTexSubImage3D
#define glTexSubImage3D bolan_gl_called(TexSubImage3D)
#undef glTextureView
#define glTextureView bolan_gl_called(TextureView)
#undef glTextureViewEXT
#define glTextureViewEXT bolan_gl_called(TextureViewEXT)
#undef glTextureViewOES
#define glTextureViewOES bolan_gl_called(TextureViewOES)
#undef glUniform1f
#define glUniform1f bolan_gl_called(Uniform1f)
#undef glUniform1i
#define glUniform1i bolan_gl_called(Uniform1i)
#undef glUniform2f
#define glUniform2f bolan_gl_called(Uniform2f)
#undef glUniform4f
#define glUniform4f bolan_gl_called(Uniform4f)
#undef glUniform4fv
#define glUniform4fv bolan_gl_called(Uniform4fv)
#undef glUniformBlockBinding
#define glUniformBlockBinding bolan_gl_called(UniformBlockBinding)
#undef glUnmapBuffer
#define glUnmapBuffer bolan_gl_called(UnmapBuffer)
#undef glUseProgram
#define glUseProgram bolan_gl_called(UseProgram)
#undef glVertexAttribDivisor
#define glVertexAttribDivisor bolan_gl_called(VertexAttribDivisor)
#undef glVertexAttribPointer
#define glVertexAttribPointer bolan_gl_called(VertexAttribPointer)
#undef glViewport
#define glViewport bolan_gl_called(Viewport)
#undef glViewportIndexedfv
#define glViewportIndexedfv bolan_gl_called(ViewportIndexedfv)

#endif
