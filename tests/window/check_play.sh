#!/bin/sh
# check_play.sh SOURCE: `./cookbook play` refuses what it cannot show, and says what it can.
set -eu
source=$1
failed=0

refuses() { # refuses WORDS ARGUMENT...
  words=$1
  shift
  status=0
  said=$("$source/cookbook" play "$@" 2>&1 </dev/null) || status=$?
  case $status$said in
    2*"$words"*) ;;
    *)
      echo "./cookbook play $*: expected status 2 and \"$words\", got $status and \"$said\""
      failed=1 ;;
  esac
}

refuses 'nothing to play called "tetris"; there are ' tetris
refuses ' small_world' tetris
refuses 'sphere_sphere is a drawing, which no window shows but its page: ./cookbook book --open, "Chapter 3' sphere_sphere
refuses 'unknown option --windows' --windows
refuses 'called like this: ./cookbook play [NAME] [--terminal] [--scene-file FILE]' small_world camera
refuses '--scene-file needs a file' --scene-file
exit "$failed"
