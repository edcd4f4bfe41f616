# What versions of ParaView call differently, for Representation.xml: properties are shared with
# ParaView's own representation by their names.

if(ParaView_VERSION VERSION_LESS 5.13)
  set(PIXELEXACT_TRANSLATION Position)
else()
  set(PIXELEXACT_TRANSLATION Translation)
endif()
