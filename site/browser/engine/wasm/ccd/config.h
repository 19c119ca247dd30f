/* libccd's configuration, as Debian builds it: double precision. */
#ifndef __CCD_CONFIG_H__
#define __CCD_CONFIG_H__
#define CCD_DOUBLE
#endif
