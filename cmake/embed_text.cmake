# Writes OUTPUT, a C++ file that defines NAMESPACE::NAME as the content of the text file INPUT.
file(READ ${INPUT} content)
file(WRITE ${OUTPUT} "// Generated from ${INPUT}.

#include \"${HEADER}\"

namespace ${NAMESPACE} {

const std::string_view ${NAME} = R\"~text~(${content})~text~\";

}  // namespace ${NAMESPACE}
")
