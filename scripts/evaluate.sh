#!/usr/bin/env bash
# Computes the results of docs/evaluation.md and writes its tables anew.
#
#   scripts/evaluate.sh [DATA [RESULTS]]
#
# DATA is a folder of the UCR archive (default: ../shared/data/ucr). RESULTS is the folder for the scores of every run as JSON
# (default: in the build's workspace). The script keeps JSON files and bags that are already there, so it goes on after an
# interruption. After a change of code, use a new folder.
# METHODS="nn_stne" restricts the comparison to some methods. NEIGHBOURS="" leaves out the other neighbourhoods of UDFS. JOBS=4 sets
# how many runs work at the same time, SEEDS=5 the number of seeds.
set -euo pipefail

scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
package=$(dirname "$scripts")
data=${1:-$package/../shared/data/ucr}
if [ ! -d "$data" ]; then
  echo "$data: expected a folder of the UCR archive, with CBF/CBF_TRAIN.tsv and so on, found none" >&2
  exit 1
fi
setup=$("$scripts/build.sh")
workspace=$(dirname "$(dirname "$setup")")
results=${2:-$workspace/evaluation}
mkdir -p "$results"

set +u
. "$setup"
set -u
shapelets=$workspace/devel/lib/contact_shapelets/shapelets
dataset=$workspace/devel/lib/contact_shapelets/switch_push_dataset
if [ ! -s "$results/switch_push_test.bag" ]; then
  if [ ! -x "$dataset" ]; then
    echo "The simulated pushes need MuJoCo: install libmujoco-dev, or put switch_push_train.bag and _test.bag into $results" >&2
    exit 1
  fi
  # As many simulated pushes as the paper had real ones: 489 and 81.
  "$dataset" --seed 1 --raw 0 --out "$results"
fi
bags=(--bags "$results/switch_push_train.bag" --test-bags "$results/switch_push_test.bag" --bags-name "switch push")
development=ECG200,CBF,FaceFour,OSULeaf,ArrowHead,BeetleFly,Car,DistalPhalanxTW,FaceAll,Ham,ItalyPowerDemand,Meat,MoteStrain,SwedishLeaf

status=0
evaluate() {  # NAME ARGUMENT...
  local name=$1
  shift
  [ -s "$results/$name.json" ] && return
  echo "== $name" >&2
  # If one data set fails, the others keep their results.
  "$shapelets" evaluate --data "$data" "${bags[@]}" --seeds "${SEEDS:-5}" --jobs "${JOBS:-0}" \
    --json "$results/$name.json.part" "$@" >"$results/$name.md" || status=$?
  [ ! -s "$results/$name.json.part" ] || mv "$results/$name.json.part" "$results/$name.json"
}

for method in ${METHODS:-kmeans udfs kshape uslm nn_stne nn_stne_paper}; do
  evaluate "method_$method" --datasets all --methods "$method"
done
# Other sizes of the neighbourhood, on the paper's data sets.
for neighbours in ${NEIGHBOURS-2 3 8 12}; do
  evaluate "method_udfs_k$neighbours" --datasets ECG200,CBF,FaceFour,OSULeaf --methods "udfs_k$neighbours"
done

# One ingredient changed at a time, on the development sets.
ablation() {  # NAME YAML
  printf '%s\n' "$2" >"$results/ablation_$1.yaml"
  evaluate "ablation_$1" --datasets "$development" --methods nn_stne --config "$results/ablation_$1.yaml"
}
ablation no_contrastive_term "objective: paper"
ablation one_scale "scales: [0.4]"
ablation no_flat_gate "flat_fraction: 0.0"
ablation length_by_l1 "sparsity: 0.1"
ablation diversity "diversity: 0.01"
ablation no_vote "voters: 0"
ablation no_random_shapelets "random_shapelets: 0"
ablation no_training "steps: 0"

/usr/bin/python3 "$scripts/evaluation_tables.py" "$results" "$package/docs/evaluation.md"
exit "$status"
