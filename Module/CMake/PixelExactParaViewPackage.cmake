# ParaView, with the VTK that it brings or uses.

if(VTK_DIR AND NOT PIXELEXACT_FINDS_PARAVIEW)
  message(FATAL_ERROR
    "PIXELEXACT_BUILD_PARAVIEW: this build folder is for the VTK in ${VTK_DIR}; the plugin needs a "
    "build folder of its own")
endif()
set(PIXELEXACT_FINDS_PARAVIEW ON CACHE INTERNAL "Whether VTK_DIR is what ParaView's package found")
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)
