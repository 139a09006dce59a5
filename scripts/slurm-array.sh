#!/usr/bin/env bash
# Spreads one trace of fluxes over a Slurm job array, and merges the shards when all are done.
#
#   scripts/slurm-array.sh submit N FOLDER TRACE-OPTIONS...
#   scripts/slurm-array.sh submit 200 /scratch/slab --phase hg:0.85 --tau 16 --mu0 1 --photons 1e12 --threads 64
#
# FOLDER must be seen by all nodes; FOLDER/result.csv appears when everything is done (result.json with JSON=1), the bytes
# of one process. STRATIFORM names the command (default: the one in the PATH), SBATCH_OPTIONS more options for
# sbatch, such as "--cpus-per-task=64 --time=4:00:00 --partition=long". Tasks keep a checkpoint every EVERY seconds
# (default 60): one that is preempted, requeued or killed goes on from it, and one that runs twice
# writes the same file. The same `submit` line again redoes only what is missing; other options in the same folder are refused.
set -euo pipefail

stratiform=${STRATIFORM:-stratiform}

submit() {
    local count=$1 folder
    [[ $count =~ ^[1-9][0-9]*$ ]] || { echo "error: N = $count is not a whole number from 1" >&2 && exit 2; }
    mkdir -p "$2" && folder=$(cd "$2" && pwd)
    shift 2
    local script options array
    script=$(realpath "${BASH_SOURCE[0]}")
    read -ra options <<<"${SBATCH_OPTIONS:-}"
    # A minute before the time is up the task is told; it stores its checkpoint and queues again.
    array=$(sbatch --parsable --array="1-$count" --requeue --signal=B:TERM@60 --open-mode=append \
        --output="$folder/task-%a.log" "${options[@]}" "$script" task "$folder" "$@")
    sbatch --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes --output="$folder/merge.log" \
        "${options[@]}" "$script" merge "$count" "$folder"
}

# One element of the array: SLURM_ARRAY_TASK_ID of SLURM_ARRAY_TASK_COUNT.
task() {
    local folder=$1 part status=0 child
    shift
    part=$folder/part-$SLURM_ARRAY_TASK_ID
    "$stratiform" trace "$@" --quiet --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --out "$part.bin" \
        --checkpoint "$part.ckpt" --checkpoint-every "${EVERY:-60}" &
    child=$!
    trap 'kill -TERM $child' TERM
    wait $child || status=$?
    # The trap interrupts the first wait.
    if [ $status -gt 128 ]; then status=0 && wait $child || status=$?; fi
    if [ $status = 130 ] && command -v scontrol >/dev/null; then
        scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID" && exit 0
    fi
    exit $status
}

merge() {
    local count=$1 folder=$2 options=() result=result.csv
    [ -z "${JSON:-}" ] || { options=(--json) && result=result.json; }
    cd "$folder"
    local parts
    mapfile -t parts < <(seq -f 'part-%.0f.bin' "$count")
    "$stratiform" merge "${options[@]}" "${parts[@]}" >"$result.partial"
    mv "$result.partial" "$result"
}

case ${1:-} in
submit | task | merge) "$@" ;;
*) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" >&2 && exit 2 ;;
esac
